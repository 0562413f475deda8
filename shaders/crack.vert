// SPDX-License-Identifier: Apache-2.0
#version 450 core
// A ribbon of two triangles along one edge of the outside (common/crack.glsl).
#include "common/frame.glsl"
#include "common/body.glsl"
#include "common/cell_look.glsl"
#include "common/gbuffer.glsl"
#include "common/crack.glsl"
#include "common/crack_cover.glsl"

out vec3 place;  // as CrackPlace has it
out float half_width;  // px
out float strength;
out float slant;
out vec3 rest;

void main() {
    CrackLine line = crack_list[gl_InstanceID + (gl_VertexID >> 2)];  // four vertices a line
    int corner = gl_VertexID & 3, end = corner >> 1;
    CrackEdge edge = crack_edges[line.edge];
    uint fragment = particle_fragment[edge.cell_a], other = particle_fragment[edge.cell_b];
    FragmentTransform t = transforms[fragment];
    vec3 p[2] = vec3[](moved(t, restPosition(edge.vertex_0)), moved(t, restPosition(edge.vertex_1)));
    rest = restPosition(end == 0 ? edge.vertex_0 : edge.vertex_1);
    float opening = openingAt(rest, t, fragment, other);
    vec3 normal = rotate(t.rotation, restNormal(end == 0 ? edge.vertex_0 : edge.vertex_1));
    vec3 to_eye = normalize(frame.eye.xyz - p[end]);
    vec4 clip[2];
    for (int i = 0; i < 2; ++i) clip[i] = frame.view_projection * vec4(lifted(p[i], normal, to_eye), 1.0);
    vec2 screen_0 = clip[0].xy / max(clip[0].w, 1e-4) * 0.5 * frame.viewport.xy;
    vec2 screen_1 = clip[1].xy / max(clip[1].w, 1e-4) * 0.5 * frame.viewport.xy;
    vec2 along = screen_1 - screen_0;
    float extent = length(along);
    along = extent > 1e-4 ? along / extent : vec2(1.0, 0.0);

    float wanted = onScreen(widthAt(line, end, fragment != other), clip[end].w);
    half_width = 0.5 * max(wanted, kLeastPixels);
    strength = strengthOf(wanted, dot(normal, to_eye), opening);
    slant = slantOf(p[1] - p[0], normal, to_eye);
    float across = ((1.0 + noise_shape.y) * half_width + 1.0) * float(2 * (corner & 1) - 1), past = kOverlap * half_width;
    place = end == 0 ? vec3(across, -past, extent + past) : vec3(across, extent + past, -past);
    vec2 offset = vec2(-along.y, along.x) * across + along * (end == 0 ? -past : past);
    gl_Position = clip[end];
    gl_Position.xy += offset * 2.0 * frame.viewport.zw * clip[end].w;
    if (clip[0].w <= frame.depth_range.x || clip[1].w <= frame.depth_range.x) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    gl_Position = unlessHidden(gl_Position, edge.cell_a);
}
