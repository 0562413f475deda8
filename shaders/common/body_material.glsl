// SPDX-License-Identifier: Apache-2.0
// The body's material at a point: `rest` is where it was when the body was whole, m.
layout(location = BODY_MATERIAL) uniform vec4 outside;      // rgb albedo, a roughness
layout(location = BODY_MATERIAL + 1) uniform vec4 inside;
layout(location = BODY_MATERIAL + 2) uniform vec2 noise_shape;  // first wavelength m, strength

// The model's own outside.
void outsideMaterial(inout Surface s, vec3 rest) {
    float coarse = noise(rest, 1.0 / (noise_shape.x * 9.0)).w;
    float speck = noise(rest, 1.0 / (noise_shape.x * 1.7)).w;
    s.albedo = outside.rgb * (1.0 + 0.05 * coarse + 0.03 * speck);
    s.roughness = clamp(outside.a * (1.0 + 0.18 * coarse), 0.05, 1.0);
}

// The broken material: lighter, rough, its normal bent by noise of the rest position (geometry.md 4a); pits are darker, as
// light gets lost in them, ridges and the rim paler with dust. `relief`: x 0 at the outside .. 1 deep; y -1 pit .. 1 ridge.
void insideMaterial(inout Surface s, vec3 rest, vec4 rotation, vec2 relief) {
    vec4 fine = fractureNoise(rest, 1.0 / noise_shape.x);
    float coarse = noise(rest, 1.0 / (noise_shape.x * 7.3)).w;
    vec3 slope = rotate(rotation, fine.xyz);
    slope -= s.normal * dot(slope, s.normal);
    s.normal = normalize(s.normal - noise_shape.y * slope);
    float tint = 1.0 + 0.22 * fine.w + 0.22 * coarse;
    float pit = max(-relief.y, 0.0), dust = max(relief.y, 0.0) + 0.4 * (1.0 - relief.x);
    tint *= (1.0 - 0.55 * pit) * (1.0 + 0.12 * dust);
    s.albedo = inside.rgb * tint * mix(vec3(1.0), vec3(1.04, 1.0, 0.94), coarse);
    s.roughness = clamp(inside.a + 0.08 * fine.w, 0.05, 1.0);
}

// An interpolated normal may point away at the silhouette, where the surface itself cannot.
void turnToEye(inout Surface s) {
    vec3 to_eye = normalize(frame.eye.xyz - s.position);
    float facing = dot(s.normal, to_eye);
    if (facing < 0.02) s.normal = normalize(s.normal + (0.02 - facing) * to_eye);
}
