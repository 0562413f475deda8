// SPDX-License-Identifier: Apache-2.0
// A face of a transparent body as it is peeled off: 8 bytes.
struct GlassLayer {
    float depth;  // reversed; 0: there is none
    vec3 normal;  // unit, out of the body
    bool enters;  // a ray from the eye goes in
    bool broken;
    bool curved;  // its corners have different normals; of what is not broken
};

const float kSame = 2e-6;  // of a depth: faces that near lie in one
bool isBehind(float depth, float last) { return depth < last * (1.0 - kSame); }

const vec2 kNormalSteps = vec2(32767.0, 16383.0);

uvec2 packLayer(GlassLayer layer) {
    uvec2 n = uvec2((0.5 + 0.5 * encodeOctahedral(layer.normal)) * kNormalSteps + 0.5);
    uint kinds = uint(layer.curved) << 29 | uint(layer.enters) << 30 | uint(layer.broken) << 31;
    return uvec2(floatBitsToUint(layer.depth), n.x | n.y << 15 | kinds);
}

GlassLayer unpackLayer(uvec2 bits) {
    vec2 n = vec2(bits.y & 0x7fffu, (bits.y >> 15) & 0x3fffu) / kNormalSteps;
    bool curved = (bits.y & 0x20000000u) != 0u, enters = (bits.y & 0x40000000u) != 0u, broken = (bits.y & 0x80000000u) != 0u;
    return GlassLayer(uintBitsToFloat(bits.x), decodeOctahedral(2.0 * n - 1.0), enters, broken, curved);
}
