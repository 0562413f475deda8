// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Triangles that are more than one lane's work, where the memory for tasks did not suffice: one work group a triangle. Slow,
// but right.
layout(local_size_x = 64) in;
#include "common/raster.glsl"
#include "common/raster_box.glsl"
#include "common/near_plane.glsl"

void fillAll(Flat f, uint name, int view) {
    if (f.shows) fillBox(Large(f, name, view, 0, view == kCamera ? 0.0 : shadowShift(f)), f.low, f.high);
}

void fillCamera(vec3 p[3], uint name) {
    vec4 clip[3], left[4];
    for (int k = 0; k < 3; ++k) clip[k] = clipOf(p[k]);
    int count = cutByNearPlane(clip, left);
    for (int k = 2; k < count; ++k) {
        Flat f = cameraFlat(left[0], left[k - 1], left[k]);
        if (isCut(clip) || !isLanesWork(f)) fillAll(f, name, kCamera);
    }
}

void main() {
    if (hasRoom()) return;
    uint triangles = triangleCount();
    for (uint t = gl_WorkGroupID.x; t < triangles; t += gl_NumWorkGroups.x) {
        uint name = nameOfTriangle(t);
        if (!isShown(name)) continue;
        vec3 p[3];
        cornersOf(name, p);
        fillCamera(p, name);
        for (int region = 0; region < 2 && shadow_texels > 0 && naming == 0; ++region) {
            Flat f = shadowFlat(p, region);
            if (!isLanesWork(f)) fillAll(f, name, 1 + region);
        }
    }
}
