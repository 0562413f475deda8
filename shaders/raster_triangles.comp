#version 450 core
// One lane a triangle: those that are small on the picture are done at once, larger ones become tasks.
layout(local_size_x = 128) in;
#include "common/raster.glsl"
#include "common/near_plane.glsl"

shared uint found_here, large_here, task_here, found_base, large_base, task_base;

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

// First square that a box touches, and how many.
ivec4 squaresOf(Flat f) {
    ivec2 first = f.low / kTaskEdge;
    return ivec4(first, f.high / kTaskEdge - first + 1);
}

uint squareCount(Flat f) {
    ivec4 squares = squaresOf(f);
    return uint(squares.z * squares.w);
}

// `place`: in `large` and in `tasks`. What lies beyond the room is lost; then nobody reads tasks.
void write(Flat f, uint name, int view, uvec2 place) {
    if (place.x < large_room) large[place.x] = Large(f, name, view, view == kCamera ? 0.0 : shadowShift(f));
    ivec4 squares = squaresOf(f);
    for (int y = 0; y < squares.w; ++y) {
        for (int x = 0; x < squares.z; ++x, ++place.y) {
            if (place.y < task_room) tasks[place.y] = uvec2(place.x, uint(squares.y + y) << 16 | uint(squares.x + x));
        }
    }
}

// What is more than one lane's work, in each view.
struct Work {
    Flat in_view[3];
    bool has[3];
};

// True: the triangle is done and may show.
bool lookFromCamera(vec3 p[3], uint name, inout Work work) {
    vec4 clip[3];
    for (int k = 0; k < 3; ++k) clip[k] = frame.view_projection * vec4(p[k], 1.0);
    if (!isCut(clip)) {
        Flat f = cameraFlat(clip[0], clip[1], clip[2]);
        if (!f.shows) return false;
        if (isLanesWork(f)) return fillCamera(f, name);
        work.in_view[kCamera] = f;
        work.has[kCamera] = true;
        return false;
    }
    vec4 left[4];
    int count = cutByNearPlane(clip, left);
    for (int k = 2; k < count; ++k) {
        Flat f = cameraFlat(left[0], left[k - 1], left[k]);
        if (f.shows) write(f, name, kCamera, uvec2(atomicAdd(large_count, 1u), atomicAdd(task_count, squareCount(f))));
    }
    return false;
}

void lookFromSun(vec3 p[3], int region, inout Work work) {
    Flat f = shadowFlat(p, region);
    if (!f.shows) return;
    if (isLanesWork(f)) {
        fillShadow(f, region);
        return;
    }
    work.in_view[1 + region] = f;
    work.has[1 + region] = true;
}

void nameFound() {
    uint lanes = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint k = gl_GlobalInvocationID.x; k < found_count; k += lanes) {
        vec3 p[3];
        cornersOf(found[k], p);
        vec4 clip[3];
        for (int c = 0; c < 3; ++c) clip[c] = frame.view_projection * vec4(p[c], 1.0);
        fillCamera(cameraFlat(clip[0], clip[1], clip[2]), found[k]);
    }
}

void depthsOf(uint triangle, bool exists) {
    Work work;
    for (int view = 0; view < 3; ++view) work.has[view] = false;
    uint name = 0u;
    bool shows = false;
    if (exists) {
        name = nameOfTriangle(triangle);
        vec3 p[3];
        cornersOf(name, p);
        shows = lookFromCamera(p, name, work);
        for (int region = 0; region < 2 && shadow_texels > 0; ++region) lookFromSun(p, region, work);
    }
    uvec2 size = uvec2(0u), place;  // triangles, squares
    for (int view = 0; view < 3; ++view) {
        if (work.has[view]) size += uvec2(1u, squareCount(work.in_view[view]));
    }
    uint found_place = shows ? atomicAdd(found_here, 1u) : 0u;
    place.x = size.x > 0u ? atomicAdd(large_here, size.x) : 0u;
    place.y = size.y > 0u ? atomicAdd(task_here, size.y) : 0u;
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        found_base = found_here > 0u ? atomicAdd(found_count, found_here) : 0u;
        large_base = large_here > 0u ? atomicAdd(large_count, large_here) : 0u;
        task_base = task_here > 0u ? atomicAdd(task_count, task_here) : 0u;
    }
    barrier();
    if (shows) found[found_base + found_place] = name;
    place += uvec2(large_base, task_base);
    for (int view = 0; view < 3; ++view) {
        if (!work.has[view]) continue;
        write(work.in_view[view], name, view, place);
        place += uvec2(1u, squareCount(work.in_view[view]));
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
            large_here = 0u;
            task_here = 0u;
        }
        barrier();
        depthsOf(first + lane, first + lane < triangles);
    }
}
