// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Grains of grit into the pictures of a frame (common/raster.glsl); one lane a face.
layout(local_size_x = 128) in;
#include "common/raster.glsl"
#include "common/near_plane.glsl"
#include "common/fill_lane.glsl"
#define GRAIN_BINDING 12
#include "common/grain.glsl"
#include "common/effect_commands.glsl"
const float kLeastTexels = 0.7;  // as grit_shadow.vert

// A large face, or one close to the eye, is larger than the edges of fill_lane.glsl are exact for.
void fillFar(Flat f, uint name) {
    ivec2 box = boxOf(f);
    Edges e = edgesFrom(f, f.low);
    for (int k = 0; k < box.x * box.y; ++k) {
        ivec2 away = ivec2(k % box.x, k / box.x);
        uint covered = 0u;
        for (int i = 0; i < SAMPLES; ++i) {
            if (covers(e, kGrid * away + sample_at[i])) covered |= 1u << i;
        }
        if (covered != 0u) putCamera(f, f.low + away, covered, name);
    }
}

void fillFarShadow(Flat f, int region) {
    ivec2 box = boxOf(f);
    Edges e = edgesFrom(f, f.low);
    float shift = shadowShift(f);
    for (int k = 0; k < box.x * box.y; ++k) {
        ivec2 away = ivec2(k % box.x, k / box.x), texel = f.low + away;
        if (covers(e, kGrid * away + kGrid / 2)) putShadow(texel, region, depthAt(f, kGrid * texel + kGrid / 2) + shift);
    }
}

void seeFromCamera(Grain g, float grow, GrainFace face, uint name) {
    if (grow == 0.0) return;
    vec4 clip[3];
    for (int k = 0; k < 3; ++k)
        clip[k] = frame.view_projection * vec4(g.position_size.xyz + grow * g.position_size.w * face.corner[k], 1.0);
    if (isCut(clip)) return;
    Flat f = cameraFlat(clip[0], clip[1], clip[2]);
    if (!f.shows) return;
    if (isNear(f)) fillCamera(f, name);
    else fillFar(f, name);
}

bool casts(Grain g, int region) {
    return naming == 0 && shadow_texels > 0 && g.position_size.w >= kLeastTexels * frame.shadow[region].x;
}

void seeFromSun(Grain g, GrainFace face, int region) {
    vec3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = g.position_size.xyz + g.position_size.w * face.corner[k];
    Flat f = shadowFlat(p, region);
    if (!f.shows) return;
    if (isNear(f)) fillShadow(f, region);
    else fillFarShadow(f, region);
}

void main() {
    uint faces = kGrainFaces * grainCount(), lanes = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint k = gl_GlobalInvocationID.x; k < faces; k += lanes) {
        uint slot = k / kGrainFaces, own = k % kGrainFaces;
        Grain g = grains[slot];
        if (g.position_size.w <= 0.0 || g.heat > 0.0) continue;
        float grow = grainGrowth(g);
        if (grow == 0.0 && !casts(g, 0) && !casts(g, 1)) continue;
        GrainFace face = grainFace(g, int(own));
        seeFromCamera(g, grow, face, kGrainBits | slot * kGrainNames | own);
        for (int region = 0; region < 2; ++region) {
            if (casts(g, region)) seeFromSun(g, face, region);
        }
    }
}
