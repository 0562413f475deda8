// SPDX-License-Identifier: Apache-2.0
// Samples that a drawn triangle leaves open, as its material is cut out or blended. What is blended covers as many
// samples as it is opaque, rounded up or down by a pattern whose neighbours make up for each other, so that the eye finds no
// grains in it: nothing has to be sorted. Which ones differs, or what lies behind would always be covered by the same.
// Pictures of which a film takes the mean turn both (common/frame.glsl), so that they average them.

// Bits of the samples that are covered. Texture slopes are asked for: call it where all of a quad do.
int coveredSamples(Looked look, Laid l) {
    if (look.material == kNoLook) return ~0;
    float cutoff = lookNumber(materialAt(look.material) + 11u);
    if (cutoff == 0.0) return ~0;
    float opacity = baseColour(look, l).a;
    if (cutoff > 0.0) return opacity < cutoff ? 0 : ~0;
    vec2 at = gl_FragCoord.xy + (gl_FrontFacing ? 0.0 : 41.0);
    int samples = max(gl_NumSamples, 1), first = int(float(samples) * pixelNoise(at.yx + 19.0)), covered = 0;
    float threshold = pixelNoise(at);
    for (int s = 0; s < samples; ++s)
        if (opacity * float(samples) > float(s) + threshold) covered |= 1 << (s + first) % samples;
    return covered;
}
