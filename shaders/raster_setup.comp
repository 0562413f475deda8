// SPDX-License-Identifier: Apache-2.0
#version 450 core
// One lane a large triangle: sets it up and makes a task of every square that it touches.
layout(local_size_x = 64) in;
#include "common/raster.glsl"
#include "common/near_plane.glsl"

shared uint task_here, task_base;

Flat flatOf(vec3 p[3], int view, int part) {
    if (view != kCamera) return shadowFlat(p, view - 1);
    vec4 clip[3], left[4];
    for (int k = 0; k < 3; ++k) clip[k] = clipOf(p[k]);
    if (!isCut(clip)) return cameraFlat(clip[0], clip[1], clip[2]);
    int count = cutByNearPlane(clip, left);
    Flat f = part == 0 ? cameraFlat(left[0], left[1], left[2]) : cameraFlat(left[0], left[2], left[3]);
    f.shows = f.shows && count > part + 2;
    return f;
}

// First square that a box touches, and how many along x and y.
ivec4 squaresOf(Flat f) {
    if (!f.shows) return ivec4(0);
    ivec2 first = f.low / kTaskEdge;
    return ivec4(first, f.high / kTaskEdge - first + 1);
}

// Tasks beyond the room are lost; then nobody reads tasks.
void writeTasks(uint triangle, ivec4 squares, uint place) {
    for (int y = 0; y < squares.w; ++y) {
        for (int x = 0; x < squares.z; ++x, ++place) {
            if (place < task_room) tasks[place] = uvec2(triangle, uint(squares.y + y) << 16 | uint(squares.x + x));
        }
    }
}

void setUp(uint triangle, bool exists) {
    ivec4 squares = ivec4(0);
    if (exists) {
        vec3 p[3];
        int view = large[triangle].view;
        cornersOf(large[triangle].name, p);
        Flat f = flatOf(p, view, large[triangle].part);
        squares = squaresOf(f);
        large[triangle].flat_on_view = f;
        large[triangle].shift = view == kCamera ? 0.0 : shadowShift(f);
    }
    uint count = uint(squares.z * squares.w), place = count > 0u ? atomicAdd(task_here, count) : 0u;
    barrier();
    if (gl_LocalInvocationIndex == 0u) task_base = task_here > 0u ? atomicAdd(task_count, task_here) : 0u;
    barrier();
    writeTasks(triangle, squares, task_base + place);
}

void main() {
    uint lane = gl_LocalInvocationIndex, lanes = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    uint triangles = min(large_count, large_room);
    for (uint first = gl_WorkGroupID.x * gl_WorkGroupSize.x; first < triangles; first += lanes) {
        if (lane == 0u) task_here = 0u;
        barrier();
        setUp(first + lane, first + lane < triangles);
    }
}
