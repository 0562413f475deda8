// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Light that a spark adds: white as it is struck, then yellow, orange and red. Behind what is solid it is not seen.
#include "common/choices.glsl"
#include "common/frame.glsl"
#include "common/tone.glsl"
#include "common/solid.glsl"
in vec2 place;
flat in float heat;
flat in float bright;
layout(location = 0) out vec4 colour;

const float kBright = 2.0;  // of the hottest, beside a white surface in the sun

void main() {
    vec3 ray = rayThrough(gl_FragCoord.xy);
    if (1.0 / gl_FragCoord.w > 1.002 * solidAlong(ray)) discard;
    float across = 1.0 - place.x * place.x, fading = place.y * place.y;
    vec3 glow = mix(vec3(0.9, 0.10, 0.01), mix(vec3(1.0, 0.55, 0.12), vec3(1.0, 0.85, 0.55), smoothstep(0.6, 1.0, heat)), smoothstep(0.05, 0.6, heat));
    float strength = bright * across * fading * smoothstep(0.0, 0.15, heat);
#ifdef RADIANCE
    vec3 light = kBright * strength * glow;  // before nothing it is seen as far as it is bright
    colour = vec4(light, clamp(max(light.r, max(light.g, light.b)), 0.0, 1.0));
#else
    colour = vec4(encodeSrgb(toneMap(kBright * glow * frame.exposure.rgb)) * strength, 0.0);
#endif
}
