// SPDX-License-Identifier: Apache-2.0
// Colliders are rendered walls, of the floor's colour or their own, with stains, the strokes of the trowel and a grain that bends
// the light.
#include "common/colliders.glsl"
#include "common/fine_grain.glsl"
#include "common/stone.glsl"

// xyz: gradient along the surface, w: value, of noise whose cells are `size` (m); `footprint`: of a pixel, m.
vec4 wallNoise(vec3 position, vec3 size, float footprint) {
    return noiseOver(position / size, footprint / min(size.x, min(size.y, size.z)));
}

// `colour`: as Collider has it. `along`: m, from the eye along the view axis.
Surface colliderSurface(vec3 position, vec3 normal, vec4 colour, float along) {
    float facing = max(abs(dot(normal, normalize(frame.eye.xyz - position))), 0.05);
    float footprint = 2.0 * frame.viewport.w * frame.depth_range.z * along / facing, size = frame.eye.w;
    float wide = wallNoise(position, vec3(1.9 * size), footprint).w;
    vec4 cloud = wallNoise(position, vec3(0.5 * size), footprint);
    vec4 stroke = wallNoise(kTurn1 * position, vec3(0.7, 0.2, 0.7) * size, footprint);
    Surface s;
    s.position = position;
    s.geometric_normal = normal;
    s.normal = normal;
    float tone = 1.0 + 0.12 * wide + 0.09 * cloud.w + 0.07 * stroke.w;
    if (kFineGrain) {
        vec4 grain = wallNoise(kTurn2 * position, vec3(0.03 * size), footprint);
        vec3 slope = 0.02 * cloud.xyz + transpose(kTurn1) * (0.03 * stroke.xyz) + transpose(kTurn2) * (0.035 * grain.xyz);
        s.normal = normalize(normal - (slope - normal * dot(normal, slope)));
        tone *= 1.0 + 0.06 * grain.w;
    }
    s.albedo = min(mix(frame.floor_colour.rgb, colour.rgb, colour.a) * tone, 1.0);
    s.roughness = stoneRoughness(cloud.w);
    s.metalness = 0.0;
    return s;
}
