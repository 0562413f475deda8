// SPDX-License-Identifier: Apache-2.0
// A point of the outside as its model file says, ready for the light.
#include "common/model_looks.glsl"

// The normal that a picture has, in a frame that follows from how UVs run over the surface.
vec3 bentNormal(vec3 normal, vec3 by_map, Laid l, vec2 uv_right, vec2 uv_up) {
    vec3 across_up = cross(l.up, normal), across_right = cross(normal, l.right);
    vec3 along_u = across_up * uv_right.x + across_right * uv_up.x;
    vec3 along_v = across_up * uv_right.y + across_right * uv_up.y;
    float most = max(dot(along_u, along_u), dot(along_v, along_v));
    if (most <= 0.0) return normal;
    float scale = inversesqrt(most) * sign(dot(cross(l.right, l.up), normal));
    return normalize(by_map.x * scale * along_u + by_map.y * scale * along_v + by_map.z * normal);
}

void modelMaterial(inout Surface s, Looked look, Laid l) {
    uint m = materialAt(look.material);
    s.albedo = baseColour(look, l).rgb;
    s.metalness = step(0.5, lookNumber(m + 7u) * numberOf(kMetallicMap, look, l));
    s.roughness = clamp(lookNumber(m + 8u) * numberOf(kRoughnessMap, look, l), 0.05, 1.0);
    if (!isUsed(useOf(kNormalMap, look))) return;
    vec3 by_map = 2.0 * numbersOf(kNormalMap, look, l).xyz - 1.0;
    by_map.xy *= lookNumber(m + 9u);
    s.normal = bentNormal(s.normal, by_map, l, ofSet(kNormalMap, look, l.uv_right), ofSet(kNormalMap, look, l.uv_up));
}
