// SPDX-License-Identifier: Apache-2.0
// Colliders are of the floor's material, without its tiles.
#include "common/colliders.glsl"
#include "common/stone.glsl"

// `along`: m, from the eye along the view axis.
Surface colliderSurface(vec3 position, vec3 normal, float along) {
    float facing = max(abs(dot(normal, normalize(frame.eye.xyz - position))), 0.05);
    float footprint = 2.0 * frame.viewport.w * frame.depth_range.z * along / facing;
    float cloud_size = 0.7 * frame.eye.w, grain_size = 0.045 * frame.eye.w;
    float cloud = noiseOver(position / cloud_size, footprint / cloud_size).w;
    float grain = noiseOver(position / grain_size, footprint / grain_size).w;
    Surface s;
    s.position = position;
    s.geometric_normal = normal;
    s.normal = normal;
    s.albedo = frame.floor_colour.rgb * (1.0 + 0.03 * cloud + 0.03 * grain);
    s.roughness = stoneRoughness(cloud);
    s.metalness = 0.0;
    return s;
}
