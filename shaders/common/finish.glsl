// SPDX-License-Identifier: Apache-2.0
// From the light of samples to what a picture holds. RADIANCE: linear light, times alpha, for a film that averages several
// pictures before they are mapped. Else mapped to the display before the samples of a pixel are averaged, which keeps edges
// between bright and dark smooth, and encoded after.
#include "common/tone.glsl"

#ifdef RADIANCE
vec4 taken(vec4 light) { return light; }
vec4 finished(vec4 mean) { return mean; }
#else
vec4 taken(vec4 light) { return vec4(toneMap(light.rgb * frame.exposure.rgb), 1.0); }
vec4 finished(vec4 mean) { return vec4(encodeSrgb(mean.rgb), 1.0); }
#endif
