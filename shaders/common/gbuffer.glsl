// SPDX-License-Identifier: Apache-2.0
// What the drawing passes leave behind for the light pass: 12 bytes a sample.
//   target 0, RGBA8:  square root of the albedo; roughness in 0..0.5, plus 0.5 for metal
//   target 1, RGBA16: shading normal and geometric normal, octahedral, mapped to 0..1
struct Surface {
    vec3 position;          // world, m
    vec3 geometric_normal;  // unit
    vec3 normal;            // unit, bent by noise
    vec3 albedo;
    float roughness;
    float metalness;        // 0 or 1
#ifdef GLOW
    vec4 glow;              // rgb: light that it sends out; a: share of the surroundings' light that reaches it
#endif
};

#ifdef GLOW
const vec4 kNoGlow = vec4(0.0, 0.0, 0.0, 1.0);
#endif

vec2 encodeOctahedral(vec3 n) {
    n /= abs(n.x) + abs(n.y) + abs(n.z);
    vec2 folded = (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
    return n.z >= 0.0 ? n.xy : folded;
}

vec3 decodeOctahedral(vec2 e) {
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    float fold = max(-n.z, 0.0);
    n.x += n.x >= 0.0 ? -fold : fold;
    n.y += n.y >= 0.0 ? -fold : fold;
    return normalize(n);
}

vec4 packMaterial(Surface s) {
    float roughness = clamp(s.roughness, 0.0, 0.99);
    return vec4(sqrt(clamp(s.albedo, 0.0, 1.0)), 0.5 * (roughness + s.metalness));
}

vec4 packNormals(Surface s) {
    return 0.5 + 0.5 * vec4(encodeOctahedral(s.normal), encodeOctahedral(s.geometric_normal));
}

// `packed_material`, `packed_normals`: the texels' bits.
Surface unpackSurface(uint packed_material, uvec2 packed_normals, vec3 position) {
    vec4 material = unpackUnorm4x8(packed_material);
    vec4 normals = vec4(unpackUnorm2x16(packed_normals.x), unpackUnorm2x16(packed_normals.y));
    Surface s;
    s.position = position;
    s.normal = decodeOctahedral(2.0 * normals.xy - 1.0);
    s.geometric_normal = decodeOctahedral(2.0 * normals.zw - 1.0);
    s.albedo = material.rgb * material.rgb;
    s.metalness = material.a >= 0.499 ? 1.0 : 0.0;
    s.roughness = clamp(2.0 * material.a - s.metalness, 0.0, 1.0);
    return s;
}
