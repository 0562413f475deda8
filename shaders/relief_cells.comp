// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Which cells are so near that their broken faces get relief. With none of them the next two passes have no work groups.
layout(local_size_x = 64) in;
#include "common/relief.glsl"
layout(std430, binding = 4) readonly buffer CellSpheres { vec4 cell_spheres[]; };  // at rest: centre, reach, m
layout(std430, binding = 16) writeonly buffer NearCells { uint near_cells[]; };
layout(std430, binding = 17) buffer NearIndices {
    uint near_command[5];
    uint near_groups[3];
};
layout(location = 0) uniform uint cell_count;
layout(location = 33) uniform uint group_count;  // of the next two passes

// Beyond the picture there is nothing to see of it; pieces that are cut by its edge are replaced for a cell more.
bool isOnPicture(vec3 world, float reach) {
    vec4 clip = frame.view_projection * vec4(world, 1.0);
    mat4 rows = transpose(frame.view_projection);
    vec2 steep = vec2(length(rows[0].xyz), length(rows[1].xyz)) + length(rows[3].xyz);
    return all(lessThanEqual(abs(clip.xy), vec2(clip.w) + 3.0 * reach * steep));
}

void main() {
    uint cell = gl_GlobalInvocationID.x;
    if (cell == 0u) near_command[0] = 0u;
    if (cell >= cell_count) return;
    vec4 sphere = cell_spheres[cell];
    vec2 relief = reliefOf(cell);
    vec3 world = moved(transforms[particle_fragment[cell]], sphere.xyz);
    float to_eye = max(distance(world, frame.eye.xyz) - sphere.w, 1e-6);
    bool near = relief.x > 0.0 && 0.5 * relief.y * frame.viewport.y > kWavesFrom * frame.depth_range.z * to_eye;
    near = near && isOnPicture(world, sphere.w);
    near_cells[cell] = near ? 1u : 0u;
    if (near) near_groups[0] = group_count;
}
