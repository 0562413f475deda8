#version 450 core
// One work group a task: a square of a triangle.
layout(local_size_x = 64) in;
#include "common/raster.glsl"

void fillCamera(Flat f, uint name, ivec2 low, ivec2 high) {
    ivec2 box = high - low + 1;
    for (int k = int(gl_LocalInvocationIndex); k < box.x * box.y; k += int(gl_WorkGroupSize.x)) {
        ivec2 pixel = low + ivec2(k % box.x, k / box.x);
        uint covered = 0u;
        for (int i = 0; i < SAMPLES; ++i) {
            if (covers(f, kGrid * pixel + sample_at[i])) covered |= 1u << i;
        }
        if (covered != 0u) putCamera(f, pixel, covered, name);
    }
}

void fillShadow(Flat f, int region, ivec2 low, ivec2 high) {
    ivec2 box = high - low + 1;
    float shift = shadowShift(f);
    for (int k = int(gl_LocalInvocationIndex); k < box.x * box.y; k += int(gl_WorkGroupSize.x)) {
        ivec2 texel = low + ivec2(k % box.x, k / box.x), at = kGrid * texel + kGrid / 2;
        if (covers(f, at)) putShadow(texel, region, depthAt(f, at) + shift);
    }
}

// What the near plane leaves of a triangle: a polygon of 0, 3 or 4 corners.
int cutByNearPlane(vec4 clip[3], out vec4 corner[4]) {
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        vec4 a = clip[k], b = clip[(k + 1) % 3];
        float a_in = a.w - a.z, b_in = b.w - b.z;
        if (a_in >= 0.0) corner[count++] = a;
        if ((a_in >= 0.0) != (b_in >= 0.0)) corner[count++] = mix(a, b, a_in / (a_in - b_in));
    }
    return count;
}

// The part of a triangle between pixels `low` and `high`. `all`: also what is one lane's work.
void fill(uint name, int view, ivec2 low, ivec2 high, bool all) {
    vec3 p[3];
    cornersOf(name, p);
    if (view != kCamera) {
        Flat f = shadowFlat(p, view - 1);
        if (f.shows && (all || !isLanesWork(f))) fillShadow(f, view - 1, max(f.low, low), min(f.high, high));
        return;
    }
    vec4 clip[3], left[4];
    for (int k = 0; k < 3; ++k) clip[k] = frame.view_projection * vec4(p[k], 1.0);
    int count = cutByNearPlane(clip, left);
    bool is_cut = count > 0 && (clip[0].z > clip[0].w || clip[1].z > clip[1].w || clip[2].z > clip[2].w);
    for (int k = 2; k < count; ++k) {
        Flat f = cameraFlat(left[0], left[k - 1], left[k]);
        if (f.shows && (all || is_cut || !isLanesWork(f))) fillCamera(f, name, max(f.low, low), min(f.high, high));
    }
}

void doTasks() {
    for (uint k = gl_WorkGroupID.x; k < task_count; k += gl_NumWorkGroups.x) {
        uvec2 task = tasks[k];
        int view = int(task.y >> 30);
        ivec2 low = kTaskEdge * ivec2(task.y & 0x7fffu, (task.y >> 15) & 0x7fffu);
        if (naming == 0 || view == kCamera) fill(task.x, view, low, low + kTaskEdge - 1, true);
    }
}

// Without the tasks, which were too many for their memory: slow, but right.
void doAll() {
    uint triangles = triangleCount();
    for (uint t = gl_WorkGroupID.x; t < triangles; t += gl_NumWorkGroups.x) {
        fill(nameOfTriangle(t), kCamera, ivec2(0), ivec2(frame.viewport.xy) - 1, false);
        for (int region = 0; region < 2 && shadow_texels > 0 && naming == 0; ++region)
            fill(nameOfTriangle(t), 1 + region, ivec2(0), ivec2(shadow_texels) - 1, false);
    }
}

void main() {
    if (task_count > task_room) doAll();
    else doTasks();
}
