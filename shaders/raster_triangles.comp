#version 450 core
// One thread a triangle: those that are small on the picture are done at once, larger ones become tasks.
layout(local_size_x = 256) in;
#include "common/raster_square.glsl"
layout(location = 9) uniform int most_pixels;  // of a box that one thread goes through
layout(location = 11) uniform uint task_room;

shared uint found_here, task_here, found_base, task_base;

bool isSmall(Flat f) {
    ivec2 box = boxOf(f);
    return box.x * box.y <= most_pixels && all(lessThanEqual(abs(f.at[1] - f.at[0]), ivec2(64 * kGrid))) &&
           all(lessThanEqual(abs(f.at[2] - f.at[0]), ivec2(64 * kGrid)));
}

bool fillCamera(Flat f, uint name) {
    vec2 slope = depthSlope(f);
    bool shows = false;
    for (int y = f.low.y; y <= f.high.y; ++y) {
        for (int x = f.low.x; x <= f.high.x; ++x) {
            for (int i = 0; i < sample_count; ++i) {
                ivec2 at = kGrid * ivec2(x, y) + sample_at[i];
                if (coversNear(f, at)) shows = putCamera(ivec2(x, y), i, depthAt(f, slope, at), name) || shows;
            }
        }
    }
    return shows;
}

void fillShadow(Flat f, int region) {
    vec2 slope = depthSlope(f);
    float shift = shadowShift(f, slope);
    for (int y = f.low.y; y <= f.high.y; ++y) {
        for (int x = f.low.x; x <= f.high.x; ++x) {
            ivec2 at = kGrid * ivec2(x, y) + kGrid / 2;
            if (coversNear(f, at)) putShadow(ivec2(x, y), region, depthAt(f, slope, at) + shift);
        }
    }
}

// Squares that a box touches: first and number.
ivec4 squaresOf(ivec2 low, ivec2 high) {
    ivec2 first = low / kTaskEdge;
    return ivec4(first, high / kTaskEdge - first + 1);
}

// What is left of a triangle to do in each view: squares of tasks.
struct Work {
    ivec4 squares[3];
    bool shows;
};

void nothingIn(out Work work) {
    for (int view = 0; view < 3; ++view) work.squares[view] = ivec4(0);
    work.shows = false;
}

void lookFromCamera(vec3 p[3], uint name, inout Work work) {
    vec4 clip[3];
    int beyond = 0;  // of the near plane
    for (int k = 0; k < 3; ++k) {
        clip[k] = frame.view_projection * vec4(p[k], 1.0);
        beyond += int(clip[k].z <= clip[k].w);
    }
    if (beyond == 0) return;
    if (beyond < 3) {
        work.squares[kCamera] = squaresOf(ivec2(0), ivec2(frame.viewport.xy) - 1);
        return;
    }
    Flat f = cameraFlat(clip);
    if (isEmpty(f)) return;
    if (isSmall(f)) work.shows = fillCamera(f, name);
    else work.squares[kCamera] = squaresOf(f.low, f.high);
}

void lookFromSun(vec3 p[3], int region, inout Work work) {
    Flat f = shadowFlat(p, region);
    if (isEmpty(f)) return;
    if (isSmall(f)) fillShadow(f, region);
    else work.squares[1 + region] = squaresOf(f.low, f.high);
}

uint tasksIn(Work work) {
    uint count = 0u;
    for (int view = 0; view < 3; ++view) count += uint(work.squares[view].z * work.squares[view].w);
    return count;
}

// Does all by itself where there is no room; a task of nobody is empty.
void writeTasks(Work work, uint name, uint place, bool has_room) {
    for (int view = 0; view < 3; ++view) {
        ivec4 squares = work.squares[view];
        for (int k = 0; k < squares.z * squares.w; ++k, ++place) {
            ivec2 square = ivec2(squares.x + k % squares.z, squares.y + k / squares.z);
            uvec2 task = uvec2(name, uint(view) << 30 | uint(square.y) << 15 | uint(square.x));
            if (place < task_room) tasks[place] = has_room ? task : uvec2(0u);
            if (!has_room) fillSquare(name, view, square, 0, 1);
        }
    }
}

void nameFound() {
    for (uint k = gl_GlobalInvocationID.x; k < found_count; k += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
        vec3 p[3];
        cornersOf(found[k], p);
        Work work;
        nothingIn(work);
        lookFromCamera(p, found[k], work);
        writeTasks(work, found[k], task_room, false);
    }
}

void main() {
    if (naming != 0) {
        nameFound();
        return;
    }
    uint thread = gl_LocalInvocationIndex, triangles = triangleCount();
    for (uint first = gl_WorkGroupID.x * gl_WorkGroupSize.x; first < triangles; first += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
        if (thread == 0u) found_here = task_here = 0u;
        barrier();
        Work work;
        nothingIn(work);
        uint t = first + thread, own = 0u;
        if (t < triangles) {
            own = nameOfTriangle(t);
            vec3 p[3];
            cornersOf(own, p);
            lookFromCamera(p, own, work);
            if (shadow_texels > 0) {
                lookFromSun(p, 0, work);
                lookFromSun(p, 1, work);
            }
        }
        uint own_tasks = tasksIn(work);
        uint task_place = own_tasks > 0u ? atomicAdd(task_here, own_tasks) : 0u;
        barrier();
        if (thread == 0u) task_base = task_here > 0u ? atomicAdd(task_count, task_here) : 0u;
        barrier();
        task_place += task_base;
        bool has_room = task_place + own_tasks <= task_room;
        if (own_tasks > 0u) writeTasks(work, own, task_place, has_room);
        bool to_be_named = work.shows || (!has_room && work.squares[kCamera].z > 0);
        uint found_place = to_be_named ? atomicAdd(found_here, 1u) : 0u;
        barrier();
        if (thread == 0u) found_base = found_here > 0u ? atomicAdd(found_count, found_here) : 0u;
        barrier();
        if (to_be_named) found[found_base + found_place] = own;
    }
}
