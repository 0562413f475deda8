// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Hairlines over what is seen (common/crack.glsl): kLanes threads an edge of the outside, since what each pixel costs is
// mostly waiting for memory.
layout(local_size_x = 128) in;
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/body.glsl"
#include "common/commands.glsl"
#include "common/visible.glsl"
#include "common/noise.glsl"
#include "common/crack_cover.glsl"
#include "common/crack.glsl"
#include "common/crack_sides.glsl"
layout(location = 1) uniform vec2 sample_position[SAMPLES];  // inside the pixel, 0..1
const uint kLanes = 4u;

// One end of the ribbon.
struct End {
    vec4 clip;
    vec2 window;  // px
    vec3 rest, normal, to_eye;
    float half_width, strength, slant;
};

End endOf(CrackLine line, int k, CrackEdge edge, uint fragment, uint other) {
    uint vertex = k == 0 ? edge.vertex_0 : edge.vertex_1;
    FragmentTransform t = transforms[fragment];
    End end;
    end.rest = restPosition(vertex);
    CrackPoint seen = crackPoint(end.rest, t, transforms[other]);
    end.normal = rotate(t.rotation, restNormal(vertex));
    end.to_eye = normalize(frame.eye.xyz - seen.middle);
    end.clip = frame.view_projection * vec4(lifted(seen.middle, end.normal, end.to_eye), 1.0);
    end.window = (end.clip.xy / max(end.clip.w, 1e-4) * 0.5 + 0.5) * frame.viewport.xy;
    float wanted = onScreen(widthAt(line, k, fragment != other), end.clip.w);
    end.half_width = 0.5 * max(gapingShare(end.rest) * wanted, kLeastPixels);
    end.strength = strengthOf(wanted, dot(end.normal, end.to_eye), seen.opening);
    return end;
}

struct Ribbon {
    End ends[2];
    vec2 along, across;  // unit
    float extent;        // px
    vec3 left;           // at rest
};

// `place`: x from the first end on, y across.
bool isInside(Ribbon r, vec2 place) {
    float t = clamp(place.x / r.extent, 0.0, 1.0);
    return place.x >= -kOverlap * r.ends[0].half_width && place.x <= r.extent + kOverlap * r.ends[1].half_width &&
           abs(place.y) <= (1.0 + noise_shape.y) * mix(r.ends[0].half_width, r.ends[1].half_width, t) + 1.0;
}

vec2 placeOf(Ribbon r, vec2 at) {
    vec2 from = at - r.ends[0].window;
    return vec2(dot(from, r.along), dot(from, r.across));
}

void paintPixel(Ribbon r, ivec2 pixel) {
    uint covered = 0u;
    for (int i = 0; i < SAMPLES; ++i) {
        vec2 place = placeOf(r, vec2(pixel) + sample_position[i]);
        if (!isInside(r, place)) continue;
        float depth = mix(r.ends[0].clip.z / r.ends[0].clip.w, r.ends[1].clip.z / r.ends[1].clip.w, place.x / r.extent);
        uint seen = depthOfSample(sampleIndex(pixel, SAMPLES, i));
        if (seen != 0u && depth >= uintBitsToFloat(seen)) covered |= 1u << i;
    }
    if (covered == 0u) return;
    vec2 place = placeOf(r, vec2(pixel) + 0.5);
    // As far along the edge itself.
    float t = place.x / r.extent, far = t * r.ends[0].clip.w, near = (1.0 - t) * r.ends[1].clip.w;
    t = clamp(far / max(far + near, 1e-6), 0.0, 1.0);
    noise_footprint = 1.0 / onScreen(1.0, mix(r.ends[0].clip.w, r.ends[1].clip.w, t));
    vec2 ragged = raggedAt(mix(r.ends[0].rest, r.ends[1].rest, t), r.left);
    CrackPlace at = CrackPlace(place.y, place.x, r.extent - place.x);
    CrackCover cover = crackCover(at, mix(r.ends[0].half_width, r.ends[1].half_width, t), mix(r.ends[0].strength, r.ends[1].strength, t),
                                  mix(r.ends[0].slant, r.ends[1].slant, t), ragged);
    uint steps = uint(-log2(max(1.0 - cover.hides, 0.02)) * kCrackSteps + 0.5);
    if (steps == 0u) return;
    steps |= uint(cover.wall * kWallSteps + 0.5) << 16;
    for (int i = 0; i < SAMPLES; ++i) {
        if ((covered >> i & 1u) != 0u) atomicAdd(visible[crackWord(pixel, SAMPLES, i)], steps);
    }
}

// Goes along the axis on which the ribbon is longer; of its columns every kLanes'th, from number `lane` on.
void paint(Ribbon r, uint lane) {
    int axis = abs(r.along.x) >= abs(r.along.y) ? 0 : 1, other = 1 - axis;
    vec2 size = frame.viewport.xy;
    vec2 start = r.ends[0].window, end = r.ends[1].window;
    float wide = (1.0 + noise_shape.y) * max(r.ends[0].half_width, r.ends[1].half_width) + 1.0;
    float first = min(start[axis], end[axis]) - wide, last = max(start[axis], end[axis]) + wide;
    float slope = r.along[other] / r.along[axis], reach = 1.5 * wide + 1.0;
    for (int u = max(int(floor(first)), 0) + int(lane); u <= min(int(last), int(size[axis]) - 1); u += int(kLanes)) {
        float middle = clamp(start[other] + slope * (float(u) + 0.5 - start[axis]), min(start[other], end[other]) - wide,
                             max(start[other], end[other]) + wide);
        int low = max(int(floor(middle - reach)), 0), high = min(int(middle + reach), int(size[other]) - 1);
        for (int v = low; v <= high; ++v) paintPixel(r, axis == 0 ? ivec2(u, v) : ivec2(v, u));
    }
}

void drawLine(CrackLine line, uint lane) {
    CrackEdge edge = crack_edges[line.edge];
    uint fragment = particle_fragment[edge.cell_a], other = particle_fragment[edge.cell_b];
    Ribbon r;
    for (int k = 0; k < 2; ++k) r.ends[k] = endOf(line, k, edge, fragment, other);
    if (max(r.ends[0].strength, r.ends[1].strength) <= 0.0) return;
    if (min(r.ends[0].clip.w, r.ends[1].clip.w) <= frame.depth_range.x) return;
    r.left = leftOf(r.ends[1].rest - r.ends[0].rest, restNormal(edge.vertex_0) + restNormal(edge.vertex_1));
    for (int k = 0; k < 2; ++k) r.ends[k].slant = slantOf(rotate(transforms[fragment].rotation, r.left), r.ends[k].normal, r.ends[k].to_eye);
    vec2 way = r.ends[1].window - r.ends[0].window;
    r.extent = max(length(way), 1e-3);
    r.along = length(way) > 1e-4 ? way / length(way) : vec2(1.0, 0.0);
    r.across = vec2(-r.along.y, r.along.x);
    paint(r, lane);
}

void main() {
    uint count = commands[kCrackCommand].instance_count, edges = gl_NumWorkGroups.x * gl_WorkGroupSize.x / kLanes;
    for (uint k = gl_GlobalInvocationID.x / kLanes; k < count; k += edges)
        drawLine(crack_list[k], gl_GlobalInvocationID.x % kLanes);
}
