// SPDX-License-Identifier: Apache-2.0
// A triangle of the mesh's broken faces, and into how many steps its edges are cut where it gets relief. An edge's steps follow
// from its two ends alone: both triangles that share it cut it alike.
#include "common/relief.glsl"
#include "common/commands.glsl"
layout(std430, binding = 3) readonly buffer InteriorIndices { uint interior_indices[]; };
layout(std430, binding = 5) readonly buffer InteriorVertices { uvec2 interior_words[]; };
layout(std430, binding = 16) readonly buffer NearCells { uint near_cells[]; };
// Of each work group's share of the triangles, for each kMostSteps: how many there will be, and how many vertices.
struct Sums { uint triangles[4], vertices[4]; };
layout(location = 33) uniform uint group_count;

const float kStep = 5.0;                         // px
const uint kMostSteps[4] = uint[](8u, 4u, 2u, 1u);  // the first for which there is room

struct Corner {
    vec3 rest;
    vec3 normal;
    vec2 place;  // x: 0 at the outside .. 1 deep; y: -1 pit .. 1 ridge
};

struct NearTriangle {
    Corner corner[3];
    uint cell;
    FragmentTransform motion;
    vec2 relief;    // of its look
    uvec3 steps;    // of the edges 0-1, 1-2, 2-0
};

Corner cornerOf(uint vertex) {
    uvec2 a = interior_words[3u * vertex], b = interior_words[3u * vertex + 1u], c = interior_words[3u * vertex + 2u];
    return Corner(uintBitsToFloat(uvec3(a, b.x)), decodeOctahedral(unpackSnorm2x16(b.y)), unpackHalf2x16(c.x));
}

uint stepsOf(Corner a, Corner b, vec3 world_a, vec3 world_b, vec2 relief) {
    vec3 middle = 0.5 * (world_a + world_b);
    float scale = pixelsPerMetre(middle), pixels = scale * distance(world_a, world_b);
    if (max(a.place.x, b.place.x) <= 0.0 || relief.y * scale <= kWavesFrom) return 1u;
    return pixels > 4.0 * kStep ? 8u : pixels > 2.0 * kStep ? 4u : pixels > kStep ? 2u : 1u;
}

uint triangleTotal() { return commands[kInteriorCommand].count / 3u; }

// Shares of the triangles, one a work group.
uvec2 shareOf(uint group) {
    uint each = (triangleTotal() + group_count - 1u) / group_count;
    return min(uvec2(group, group + 1u) * each, uvec2(triangleTotal()));
}

// Is it replaced?
bool nearTriangle(uint t, out NearTriangle near) {
    uint cell = interior_words[3u * interior_indices[3u * t] + 2u].y;  // of all three corners
    if (near_cells[cell] == 0u) return false;
    for (uint k = 0u; k < 3u; ++k) near.corner[k] = cornerOf(interior_indices[3u * t + k]);
    near.cell = cell;
    near.motion = transforms[particle_fragment[cell]];
    near.relief = reliefOf(cell);
    vec3 world[3];
    for (int k = 0; k < 3; ++k) world[k] = moved(near.motion, near.corner[k].rest);
    for (int k = 0; k < 3; ++k) near.steps[k] = stepsOf(near.corner[k], near.corner[(k + 1) % 3], world[k], world[(k + 1) % 3], near.relief);
    return true;
}

uint stepsAcross(uvec3 steps, uint most) { return min(max(steps.x, max(steps.y, steps.z)), most); }

uint trianglesIn(uint steps) { return steps * steps; }

uint verticesIn(uint steps) { return (steps + 1u) * (steps + 2u) / 2u; }
