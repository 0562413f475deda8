// SPDX-License-Identifier: Apache-2.0
// Samples that a drawn triangle leaves open, as its material is cut out or blended. What is blended covers as many
// samples as it is opaque, by a pattern that sticks to the body (Wyman and McGuire, Hashed Alpha Testing, 2017): nothing
// has to be sorted. Pictures of which a film takes the mean turn it (common/frame.glsl), so that they average it.

float hashedCell(vec3 cell) {
    uvec3 q = uvec3(ivec3(floor(cell))) * uvec3(1597334677u, 3812015801u, 2798796415u);
    uint h = (q.x ^ q.y ^ q.z) * 1597334677u;
    h = (h ^ h >> 15) * 2246822519u;
    return float((h ^ h >> 13) >> 8) / 16777216.0;
}

// Evenly between 0 and 1, of grains as large as a pixel; `right`, `up`: how the place at rest (m) changes to the next.
float hashedThreshold(vec3 rest, vec3 right, vec3 up) {
    float level = log2(max(max(length(right), length(up)), 1e-9));
    float coarse = fract(level), fine_size = exp2(floor(level));
    float x = mix(hashedCell(rest / fine_size), hashedCell(rest / (2.0 * fine_size)), coarse);
    float a = min(coarse, 1.0 - coarse);  // the mean of two even numbers is not even; this makes it so
    if (x < a) return x * x / (2.0 * a * (1.0 - a));
    return x < 1.0 - a ? (x - 0.5 * a) / (1.0 - a) : 1.0 - (1.0 - x) * (1.0 - x) / (2.0 * a * (1.0 - a));
}

// Bits of the samples that are covered. Texture slopes are asked for: call it where all of a quad do.
int coveredSamples(Looked look, Laid l, vec3 rest) {
    vec3 right = dFdx(rest), up = dFdy(rest);
    if (look.material == kNoLook) return ~0;
    float cutoff = lookNumber(materialAt(look.material) + 11u);
    if (cutoff == 0.0) return ~0;
    float opacity = baseColour(look, l).a;
    if (cutoff > 0.0) return opacity < cutoff ? 0 : ~0;
    float threshold = fract(hashedThreshold(rest, right, up) + frame.exposure.w);
    int samples = max(gl_NumSamples, 1), covered = 0;
    for (int s = 0; s < samples; ++s)
        if (opacity * float(samples) > float(s) + threshold) covered |= 1 << s;
    return covered;
}
