// SPDX-License-Identifier: Apache-2.0
#version 450 core
// One lane a triangle: those that are small on the picture are done at once, larger ones are noted.
layout(local_size_x = 128) in;
#include "common/raster.glsl"
#include "common/near_plane.glsl"
#include "common/fill_lane.glsl"

shared uint found_here, large_here, found_base, large_base;

// What becomes of a triangle in a view.
const int kDone = 0, kDoneMayShow = 1, kLarge = 2;

int lookFromCamera(vec3 p[3], uint name, out bool is_cut) {
    vec4 clip[3];
    for (int k = 0; k < 3; ++k) clip[k] = clipOf(p[k]);
    is_cut = isCut(clip);
    if (is_cut) return all(greaterThan(vec3(clip[0].z, clip[1].z, clip[2].z), vec3(clip[0].w, clip[1].w, clip[2].w))) ? kDone : kLarge;
    Flat f = cameraFlat(clip[0], clip[1], clip[2]);
    if (!f.shows) return kDone;
    if (!isLanesWork(f)) return kLarge;
    return fillCamera(f, name) ? kDoneMayShow : kDone;
}

int lookFromSun(vec3 p[3], int region) {
    Flat f = shadowFlat(p, region);
    if (!f.shows) return kDone;
    if (!isLanesWork(f)) return kLarge;
    fillShadow(f, region);
    return kDone;
}

void nameFound() {
    uint lanes = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint k = gl_GlobalInvocationID.x; k < found_count; k += lanes) {
        vec3 p[3];
        bool is_cut;
        cornersOf(found[k], p);
        lookFromCamera(p, found[k], is_cut);
    }
}

// What lies beyond the room is lost; then nobody reads it.
void note(uint name, int view, int part, uint place) {
    if (place >= large_room) return;
    large[place].name = name;
    large[place].view = view;
    large[place].part = part;
}

void depthsOf(uint triangle, bool exists) {
    uint name = 0u, views = 0u;  // a bit for each view in which it is large, and one for what the near plane makes two of
    bool shows = false;
    if (exists) name = nameOfTriangle(triangle);
    if (exists && isShown(name)) {
        vec3 p[3];
        bool is_cut;
        cornersOf(name, p);
        int seen = lookFromCamera(p, name, is_cut);
        shows = kNamesLater && seen == kDoneMayShow;
        if (seen == kLarge) views = is_cut ? 9u : 1u;
        for (int region = 0; region < 2 && shadow_texels > 0; ++region) {
            if (lookFromSun(p, region) == kLarge) views |= 2u << region;
        }
    }
    uint found_place = shows ? atomicAdd(found_here, 1u) : 0u;
    uint place = views != 0u ? atomicAdd(large_here, uint(bitCount(views))) : 0u;
    barrier();
    if (gl_LocalInvocationIndex == 0u) {
        found_base = found_here > 0u ? atomicAdd(found_count, found_here) : 0u;
        large_base = large_here > 0u ? atomicAdd(large_count, large_here) : 0u;
    }
    barrier();
    if (shows) found[found_base + found_place] = name;
    place += large_base;
    for (; views != 0u; views &= views - 1u, ++place) {
        int bit = findLSB(views);
        note(name, bit == 3 ? kCamera : bit, bit == 3 ? 1 : 0, place);
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
        }
        barrier();
        depthsOf(first + lane, first + lane < triangles);
    }
}
