// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A spark as a streak: the way that it comes while the film is open, in this picture's part of that time.
#include "common/frame.glsl"
#define GRAIN_BINDING 2
#include "common/grain.glsl"
#include "common/spark.glsl"
layout(location = 2) uniform vec4 opening;  // s beside the picture's moment, from and to; shares of the whole time there
layout(location = 0) in uint number;       // of the grain
noperspective out vec2 place;  // px along the streak from its tail, and across
flat out Spark spark;

void main() {
    Grain g = grains[number];
    spark = Spark(vec4(0.0), vec2(0.0), vec3(0.0), 0u);
    place = vec2(0.0);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside the picture
    vec2 rest = unpackHalf2x16(g.turn.y);  // velocity along z; age
    vec3 velocity = vec3(unpackHalf2x16(g.turn.x), rest.x);
    float from = max(opening.x, -rest.y), to = opening.y;  // before that it was not yet struck
    if (to <= from) return;
    vec4 head = frame.view_projection * vec4(g.position_size.xyz + to * velocity, 1.0);
    vec4 tail = frame.view_projection * vec4(g.position_size.xyz + from * velocity, 1.0);
    if (head.w <= frame.depth_range.x || tail.w <= frame.depth_range.x) return;
    vec2 to_pixels = 0.5 * frame.viewport.xy;
    vec2 first = tail.xy / tail.w * to_pixels, last = head.xy / head.w * to_pixels;
    float way = length(last - first);
    vec2 along = way > 1e-3 ? (last - first) / way : vec2(0.0, 1.0);
    float radius = 0.5 * g.position_size.w * frame.viewport.y / (2.0 * frame.depth_range.z * head.w);

    float whole = opening.y - opening.x;
    float share = (from - opening.x) / whole;
    spark.streak = vec4(way, radius, way * whole / (to - from), sparkBurst(g.seed, g.heat) * kBurstSize * radius);
    spark.taper = vec2(mix(opening.z, opening.w, share), opening.w);
    spark.light = sparkLight(g.heat);
    spark.seed = g.seed;
    float reach = max(2.0 * max(radius, kLeastSparkRadius) + 0.5, spark.streak.w);
    vec2 side = vec2(2 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID >> 1) - 1) * reach;
    place = vec2((gl_VertexID >> 1) * way + side.y, side.x);
    vec4 end = side.y > 0.0 ? head : tail;
    end.xy += (side.x * vec2(-along.y, along.x) + side.y * along) / to_pixels * end.w;
    gl_Position = end;
}
