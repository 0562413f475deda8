// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A spark as a streak: the way that it has come while a film would be open.
#include "common/frame.glsl"
#define GRAIN_BINDING 2
#include "common/grain.glsl"
out vec2 place;  // x: -1..1 across, y: 0 at the tail .. 1 at the head
flat out float heat;
flat out float bright;
const float kLeastPixels = 1.6;  // across

void main() {
    Grain g = grains[gl_InstanceID];
    heat = g.heat;
    bright = 0.0;
    place = vec2(2 * (gl_VertexID & 1) - 1, gl_VertexID >> 1);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // outside the picture
    if (g.position_size.w <= 0.0 || g.heat <= 0.0) return;
    vec2 rest = unpackHalf2x16(g.turn.y);  // velocity along z; s of the streak
    vec3 velocity = vec3(unpackHalf2x16(g.turn.x), rest.x);
    vec4 head = frame.view_projection * vec4(g.position_size.xyz, 1.0);
    vec4 tail = frame.view_projection * vec4(g.position_size.xyz - rest.y * velocity, 1.0);
    if (head.w <= frame.depth_range.x || tail.w <= frame.depth_range.x) return;
    vec2 along = (head.xy / head.w - tail.xy / tail.w) * frame.viewport.xy;
    along = length(along) > 1e-4 ? normalize(along) : vec2(0.0, 1.0);
    float pixels = g.position_size.w * frame.viewport.y / (2.0 * frame.depth_range.z * head.w);
    float width = max(pixels, kLeastPixels);
    bright = clamp(pixels / width, 0.15, 1.0);
    vec4 end = place.y > 0.5 ? head : tail;
    end.xy += (place.x * vec2(-along.y, along.x) + (2.0 * place.y - 1.0) * along) * width * frame.viewport.zw * end.w;
    gl_Position = end;
}
