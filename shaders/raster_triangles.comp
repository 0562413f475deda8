#version 450 core
// One lane a triangle: those that are small on the picture are done at once, larger ones become tasks.
layout(local_size_x = 128) in;
#include "common/raster.glsl"

shared uint found_here, task_here, found_base, task_base;

// One loop and not two, or a group of lanes would take as long as the tallest box times the widest.
bool fillCamera(Flat f, uint name) {
    NearEdges e = nearEdges(f);
    ivec3 row = e.at_low, here = row, right = kGrid * e.along_x, up = kGrid * e.along_y;
    ivec2 pixel = f.low, box = boxOf(f);
    bool shows = false;
    for (int left = box.x * box.y; left > 0; --left) {
        uint covered = 0u;
        for (int i = 0; i < SAMPLES; ++i) {
            if (isInside(here + sample_at[i].x * e.along_x + sample_at[i].y * e.along_y)) covered |= 1u << i;
        }
        if (covered != 0u) shows = putCamera(f, pixel, covered, name) || shows;
        ++pixel.x;
        here += right;
        if (pixel.x > f.high.x) {
            pixel = ivec2(f.low.x, pixel.y + 1);
            row += up;
            here = row;
        }
    }
    return shows;
}

void fillShadow(Flat f, int region) {
    NearEdges e = nearEdges(f);
    ivec3 row = e.at_low + kGrid / 2 * (e.along_x + e.along_y), here = row, right = kGrid * e.along_x, up = kGrid * e.along_y;
    ivec2 texel = f.low, box = boxOf(f);
    float shift = shadowShift(f);
    for (int left = box.x * box.y; left > 0; --left) {
        if (isInside(here)) putShadow(texel, region, depthAt(f, kGrid * texel + kGrid / 2) + shift);
        ++texel.x;
        here += right;
        if (texel.x > f.high.x) {
            texel = ivec2(f.low.x, texel.y + 1);
            row += up;
            here = row;
        }
    }
}

// Squares that a box touches: first and number.
ivec4 squaresOf(ivec2 low, ivec2 high) {
    ivec2 first = low / kTaskEdge;
    return ivec4(first, high / kTaskEdge - first + 1);
}

// What is left to do, in squares; true: the triangle is done and may show.
bool lookFromCamera(vec3 p[3], uint name, out ivec4 squares) {
    squares = ivec4(0);
    vec4 a = frame.view_projection * vec4(p[0], 1.0), b = frame.view_projection * vec4(p[1], 1.0),
         c = frame.view_projection * vec4(p[2], 1.0);
    int beyond = int(a.z <= a.w) + int(b.z <= b.w) + int(c.z <= c.w);  // of the near plane
    if (beyond == 0) return false;
    if (beyond < 3) {
        squares = squaresOf(ivec2(0), ivec2(frame.viewport.xy) - 1);
        return false;
    }
    Flat f = cameraFlat(a, b, c);
    if (!f.shows) return false;
    if (isLanesWork(f)) return fillCamera(f, name);
    squares = squaresOf(f.low, f.high);
    return false;
}

ivec4 lookFromSun(vec3 p[3], int region) {
    if (shadow_texels == 0) return ivec4(0);
    Flat f = shadowFlat(p, region);
    if (!f.shows) return ivec4(0);
    if (!isLanesWork(f)) return squaresOf(f.low, f.high);
    fillShadow(f, region);
    return ivec4(0);
}

// Tasks beyond the room are lost; then nobody reads tasks (raster_squares.comp).
uint writeTasks(uint place, ivec4 squares, int view, uint name) {
    for (int y = 0; y < squares.w; ++y) {
        for (int x = 0; x < squares.z; ++x, ++place) {
            uvec2 square = uvec2(squares.xy + ivec2(x, y));
            if (place < task_room) tasks[place] = uvec2(name, uint(view) << 30 | square.y << 15 | square.x);
        }
    }
    return place;
}

void nameFound() {
    uint lanes = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint k = gl_GlobalInvocationID.x; k < found_count; k += lanes) {
        vec3 p[3];
        cornersOf(found[k], p);
        ivec4 squares;
        lookFromCamera(p, found[k], squares);
    }
}

void main() {
    if (naming != 0) {
        nameFound();
        return;
    }
    uint lane = gl_LocalInvocationIndex, triangles = triangleCount(), lanes = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint first = gl_WorkGroupID.x * gl_WorkGroupSize.x; first < triangles; first += lanes) {
        if (lane == 0u) {
            found_here = 0u;
            task_here = 0u;
        }
        barrier();
        ivec4 camera = ivec4(0), near = ivec4(0), far = ivec4(0);
        uint name = 0u;
        bool shows = false;
        if (first + lane < triangles) {
            name = nameOfTriangle(first + lane);
            vec3 p[3];
            cornersOf(name, p);
            shows = lookFromCamera(p, name, camera);
            near = lookFromSun(p, 0);
            far = lookFromSun(p, 1);
        }
        uint count = uint(camera.z * camera.w + near.z * near.w + far.z * far.w);
        uint found_place = shows ? atomicAdd(found_here, 1u) : 0u;
        uint task_place = count > 0u ? atomicAdd(task_here, count) : 0u;
        barrier();
        if (lane == 0u) {
            found_base = found_here > 0u ? atomicAdd(found_count, found_here) : 0u;
            task_base = task_here > 0u ? atomicAdd(task_count, task_here) : 0u;
        }
        barrier();
        if (shows) found[found_base + found_place] = name;
        if (count > 0u) {
            uint place = writeTasks(task_base + task_place, camera, kCamera, name);
            place = writeTasks(place, near, 1, name);
            writeTasks(place, far, 2, name);
        }
    }
}
