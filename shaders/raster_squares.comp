#version 450 core
// One work group a task: a square of a triangle.
layout(local_size_x = 64) in;
#include "common/raster_square.glsl"
layout(location = 11) uniform uint task_room;

void main() {
    uint count = min(task_count, task_room);
    for (uint k = gl_WorkGroupID.x; k < count; k += gl_NumWorkGroups.x) {
        uvec2 task = tasks[k];
        int view = int(task.y >> 30);
        if (task.x == 0u || (naming != 0 && view != kCamera)) continue;
        ivec2 square = ivec2(task.y & 0x7fffu, (task.y >> 15) & 0x7fffu);
        fillSquare(task.x, view, square, int(gl_LocalInvocationIndex), int(gl_WorkGroupSize.x));
    }
}
