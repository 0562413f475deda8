// SPDX-License-Identifier: Apache-2.0
// The body's material at a point: `rest` is where it was when the body was whole, m.
layout(location = BODY_MATERIAL) uniform vec4 outside;      // rgb albedo, a roughness
layout(location = BODY_MATERIAL + 1) uniform vec4 inside;
layout(location = BODY_MATERIAL + 2) uniform vec3 noise_shape;  // first wavelength m, strength, share of detail near the camera
layout(location = BODY_MATERIAL + 3) uniform vec4 texture_colour;  // rgb, a: its share of the solid
layout(location = BODY_MATERIAL + 4) uniform vec4 texture_shape;  // 1/m of the pattern, its share on the outside, coat m, variation
#include "common/solid_texture.glsl"

// The model's own outside.
void outsideMaterial(inout Surface s, vec3 rest) {
    float coarse = noise(rest, 1.0 / (noise_shape.x * 9.0)).w;
    float speck = noise(rest, 1.0 / (noise_shape.x * 1.7)).w;
    vec3 colour = outside.rgb;
#if TEXTURE != TEXTURE_NONE
    Solid solid = solidAt(rest);
    colour = mix(colour, texture_colour.rgb, texture_shape.y * solid.other) * mix(solid.skin, solid.tone, texture_shape.y);
#endif
    s.albedo = colour * (1.0 + 0.05 * coarse + 0.03 * speck);
    s.roughness = clamp(outside.a * (1.0 + 0.18 * coarse), 0.05, 1.0);
}

// Where a pixel is small, the octaves below those of fractureNoise(); xyz: gradient, w: value. A loop in place of a branch:
// software renderers go through branches that no pixel takes, but not through loops.
const float kDetailFrom = 0.06, kDetailWhole = 0.03;  // widths of a pixel, of the noise's first wavelength
vec4 nearDetail(vec3 rest) {
    float pixel = pixelAt(rest) / noise_shape.x, share = noise_shape.z * (1.0 - smoothstep(kDetailWhole, kDetailFrom, pixel));
    vec4 detail = vec4(0.0);
    for (bool is_near = share > 0.0; is_near; is_near = false) {
        vec3 p = rest / noise_shape.x;
        vec4 a = noiseOver(8.3 * (kTurn1 * p), 8.3 * pixel), b = noiseOver(17.0 * (kTurn2 * p), 17.0 * pixel);
        vec4 c = noiseOver(35.0 * p, 35.0 * pixel);
        detail.xyz = share * (0.25 * transpose(kTurn1) * a.xyz + 0.2 * transpose(kTurn2) * b.xyz + 0.15 * c.xyz);
        detail.w = share * (0.4 * a.w + 0.3 * b.w + 0.3 * c.w);
    }
    return detail;
}

// The broken material: lighter, rough, its normal bent by noise of the rest position (geometry.md 4a); pits are darker, as
// light gets lost in them, ridges and the rim paler with dust. `relief`: x 0 at the outside .. 1 deep; y -1 pit .. 1 ridge.
// `coat`: share of the outside's coat there, 0..1.
void insideMaterial(inout Surface s, vec3 rest, vec4 rotation, vec2 relief, float coat) {
    vec4 fine = fractureNoise(rest, 1.0 / noise_shape.x);
    float coarse = noise(rest, 1.0 / (noise_shape.x * 7.3)).w, rough = 1.0 - 0.8 * coat;
    vec3 colour = inside.rgb;
#if TEXTURE != TEXTURE_NONE
    Solid solid = solidAt(rest);
    colour = mix(colour, texture_colour.rgb, solid.other) * solid.tone;
    rough *= 1.0 - solid.smoothed;
#endif
    vec4 detail = nearDetail(rest);
    vec3 slope = rotate(rotation, fine.xyz + detail.xyz);
    slope -= s.normal * dot(slope, s.normal);
    s.normal = normalize(s.normal - noise_shape.y * rough * slope);
    float tint = 1.0 + rough * (0.22 * fine.w + 0.22 * coarse + 0.15 * detail.w);
    float pit = max(-relief.y, 0.0), dust = max(relief.y, 0.0) + 0.4 * (1.0 - relief.x);
    tint *= (1.0 - 0.55 * pit) * (1.0 + 0.12 * dust);
    s.albedo = mix(colour * tint * mix(vec3(1.0), vec3(1.04, 1.0, 0.94), coarse), outside.rgb, coat);
    s.roughness = clamp(mix(inside.a * mix(0.55, 1.0, rough), outside.a, coat) + 0.08 * fine.w, 0.05, 1.0);
}

// Share of the coat at a place `depth` (relief.x) deep, from how place and depth change from pixel to pixel: the depth counts
// rings of cells, its slope tells how far away the outside is.
float coatAt(float depth, vec3 to_right, vec3 up, vec2 deeper) {
    float a = dot(to_right, to_right), b = dot(to_right, up), c = dot(up, up);
    float steep = (c * deeper.x * deeper.x - 2.0 * b * deeper.x * deeper.y + a * deeper.y * deeper.y) / max(a * c - b * b, 1e-30);
    float away = depth * inversesqrt(max(steep, 1e-12)), blur = 0.5 * sqrt(max(a, c));
    return texture_shape.z > 0.0 ? 1.0 - smoothstep(-blur, blur, away - texture_shape.z) : 0.0;
}

// An interpolated normal may point away at the silhouette, where the surface itself cannot.
void turnToEye(inout Surface s) {
    vec3 to_eye = normalize(frame.eye.xyz - s.position);
    float facing = dot(s.normal, to_eye);
    if (facing < 0.02) s.normal = normalize(s.normal + (0.02 - facing) * to_eye);
}
