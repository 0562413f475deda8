// SPDX-License-Identifier: Apache-2.0
#version 450 core
// One work group a task: a square of a triangle.
layout(local_size_x = 32) in;
#include "common/raster.glsl"
#include "common/raster_box.glsl"

void main() {
    if (!hasRoom()) return;  // raster_large.comp does it
    for (uint k = gl_WorkGroupID.x; k < task_count; k += gl_NumWorkGroups.x) {
        uvec2 task = tasks[k];
        ivec2 low = kTaskEdge * ivec2(task.y & 0xffffu, task.y >> 16);
        if (naming == 0 || large[task.x].view == kCamera) fillBox(large[task.x], low, low + kTaskEdge - 1);
    }
}
