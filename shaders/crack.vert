// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A ribbon of two triangles along one edge of the outside (common/crack.glsl).
#include "common/frame.glsl"
#include "common/body.glsl"
#include "common/cell_look.glsl"
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
#include "common/crack_cover.glsl"
#include "common/crack.glsl"

out vec3 place;  // as CrackPlace has it
out float half_width;  // px
out float strength;
out float slant;
out vec3 rest;
flat out vec3 left;  // at rest

void main() {
    CrackLine line = crack_list[gl_InstanceID + (gl_VertexID >> 2)];  // four vertices a line
    int corner = gl_VertexID & 3, end = corner >> 1;
    CrackEdge edge = crack_edges[line.edge];
    uint fragment = particle_fragment[edge.cell_a], other = particle_fragment[edge.cell_b];
    FragmentTransform t = transforms[fragment];
    vec3 rests[2] = vec3[](restPosition(edge.vertex_0), restPosition(edge.vertex_1));
    vec3 normals[2] = vec3[](restNormal(edge.vertex_0), restNormal(edge.vertex_1));
    CrackPoint points[2];
    for (int i = 0; i < 2; ++i) points[i] = crackPoint(rests[i], t, transforms[other]);
    rest = rests[end];
    left = leftOf(rests[1] - rests[0], normals[0] + normals[1]);
    vec3 normal = rotate(t.rotation, normals[end]);
    vec3 to_eye = normalize(frame.eye.xyz - points[end].middle);
    vec4 clip[2];
    for (int i = 0; i < 2; ++i) clip[i] = frame.view_projection * vec4(lifted(points[i].middle, normal, to_eye), 1.0);
    vec2 screen_0 = clip[0].xy / max(clip[0].w, 1e-4) * 0.5 * frame.viewport.xy;
    vec2 screen_1 = clip[1].xy / max(clip[1].w, 1e-4) * 0.5 * frame.viewport.xy;
    vec2 along = screen_1 - screen_0;
    float extent = length(along);
    along = extent > 1e-4 ? along / extent : vec2(1.0, 0.0);

    float wanted = onScreen(widthAt(line, end, fragment != other), clip[end].w);
    half_width = 0.5 * max(gapingShare(rest) * wanted, kLeastPixels);
    strength = strengthOf(wanted, dot(normal, to_eye), points[end].opening);
    slant = slantOf(rotate(t.rotation, left), normal, to_eye);
    float across = ((1.0 + noise_shape.y) * half_width + 1.0) * float(2 * (corner & 1) - 1), past = kOverlap * half_width;
    place = end == 0 ? vec3(across, -past, extent + past) : vec3(across, extent + past, -past);
    vec2 offset = vec2(-along.y, along.x) * across + along * (end == 0 ? -past : past);
    gl_Position = clip[end];
    gl_Position.xy += offset * 2.0 * frame.viewport.zw * clip[end].w;
    if (clip[0].w <= frame.depth_range.x || clip[1].w <= frame.depth_range.x) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    gl_Position = unlessHidden(gl_Position, edge.cell_a);
}
