// SPDX-License-Identifier: Apache-2.0
#version 450 core
// How many triangles the relief makes of those that are near: of each work group's share of the mesh.
layout(local_size_x = 128) in;
#include "common/gbuffer.glsl"
#include "common/near_triangle.glsl"
layout(std430, binding = 8) writeonly buffer GroupSums { Sums sums[]; };

shared Sums here;

void main() {
    uint lane = gl_LocalInvocationIndex;
    if (lane < 4u) {
        here.triangles[lane] = 0u;
        here.vertices[lane] = 0u;
    }
    barrier();
    uvec2 share = shareOf(gl_WorkGroupID.x);
    for (uint t = share.x + lane; t < share.y; t += gl_WorkGroupSize.x) {
        NearTriangle near;
        if (!nearTriangle(t, near)) continue;
        for (int k = 0; k < 4; ++k) {
            uint steps = stepsAcross(near.steps, kMostSteps[k]);
            atomicAdd(here.triangles[k], trianglesIn(steps));
            atomicAdd(here.vertices[k], verticesIn(steps));
        }
    }
    barrier();
    if (lane < 4u) {
        sums[gl_WorkGroupID.x].triangles[lane] = here.triangles[lane];
        sums[gl_WorkGroupID.x].vertices[lane] = here.vertices[lane];
    }
}
