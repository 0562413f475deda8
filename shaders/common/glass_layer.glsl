// SPDX-License-Identifier: Apache-2.0
// A face of a transparent body as it is peeled off: 8 bytes.
struct GlassLayer {
    float depth;  // reversed; 0: there is none
    vec3 normal;  // unit, out of the body
    bool enters;  // a ray from the eye goes in
    bool broken;
};

const float kSame = 2e-6;  // of a depth: faces that near lie in one
bool isBehind(float depth, float last) { return depth < last * (1.0 - kSame); }

uvec2 packLayer(GlassLayer layer) {
    uvec2 n = uvec2((0.5 + 0.5 * encodeOctahedral(layer.normal)) * 32767.0 + 0.5);
    return uvec2(floatBitsToUint(layer.depth), n.x | n.y << 15 | uint(layer.enters) << 30 | uint(layer.broken) << 31);
}

GlassLayer unpackLayer(uvec2 bits) {
    vec2 n = vec2(bits.y & 0x7fffu, (bits.y >> 15) & 0x7fffu) / 32767.0;
    return GlassLayer(uintBitsToFloat(bits.x), decodeOctahedral(2.0 * n - 1.0), (bits.y & 0x40000000u) != 0u, (bits.y & 0x80000000u) != 0u);
}
