#version 450 core
// A ribbon along one edge of the outside, widened on the screen: at least kLeastPixels wide, soft at its rim. Where the
// two cells belong to different fragments it fades as they part: then the gap itself is what one sees.
#include "common/frame.glsl"
#include "common/body.glsl"
#include "common/gbuffer.glsl"
struct CrackEdge {
    uint vertex_0, vertex_1;  // exterior vertices of cell_a
    uint cell_a, cell_b;
    uint bond;
};
layout(std430, binding = 3) readonly buffer CrackList { uint crack_list[]; };
layout(std430, binding = 4) readonly buffer CrackEdges { CrackEdge crack_edges[]; };
layout(std430, binding = 5) readonly buffer ExteriorVertices { uint exterior_words[]; };  // 6 words a vertex
layout(location = 0) uniform float width;  // m

out float across;            // px from the middle
out float half_width;        // px
out float strength;
out vec3 rest;

const float kLeastPixels = 1.3;
const float kFullUpTo = 0.5, kGoneAt = 3.0;  // opening gap, in widths

vec3 restPosition(uint vertex) {
    uint word = 6u * vertex;
    return uintBitsToFloat(uvec3(exterior_words[word], exterior_words[word + 1u], exterior_words[word + 2u]));
}

vec3 restNormal(uint vertex) { return decodeOctahedral(unpackSnorm2x16(exterior_words[6u * vertex + 3u])); }

// How far two fragments have carried a point of their common border apart, m.
float openingAt(vec3 p, FragmentTransform t, uint fragment, uint other) {
    return fragment == other ? 0.0 : distance(moved(t, p), moved(transforms[other], p));
}

void main() {
    CrackEdge edge = crack_edges[crack_list[gl_InstanceID]];
    uint fragment = particle_fragment[edge.cell_a], other = particle_fragment[edge.cell_b];
    FragmentTransform t = transforms[fragment];
    vec3 p[2] = vec3[](moved(t, restPosition(edge.vertex_0)), moved(t, restPosition(edge.vertex_1)));
    int end = gl_VertexID >> 1;
    rest = restPosition(end == 0 ? edge.vertex_0 : edge.vertex_1);
    float opening = openingAt(rest, t, fragment, other);
    vec3 normal = rotate(t.rotation, restNormal(end == 0 ? edge.vertex_0 : edge.vertex_1));
    vec3 to_eye = normalize(frame.eye.xyz - p[end]);
    // Lift the line off the surface: a little outward, and towards the camera by what the ribbon's slope needs.
    vec4 clip[2];
    for (int i = 0; i < 2; ++i) {
        vec3 lifted = p[i] + 0.25 * width * normal + 0.75 * width * to_eye;
        clip[i] = frame.view_projection * vec4(lifted, 1.0);
    }
    vec2 screen_0 = clip[0].xy / max(clip[0].w, 1e-4) * 0.5 * frame.viewport.xy;
    vec2 screen_1 = clip[1].xy / max(clip[1].w, 1e-4) * 0.5 * frame.viewport.xy;
    vec2 along = screen_1 - screen_0;
    along = length(along) > 1e-4 ? normalize(along) : vec2(1.0, 0.0);

    float pixels_per_metre = frame.viewport.y / (2.0 * frame.depth_range.z * max(clip[end].w, frame.depth_range.x));
    float wanted = width * pixels_per_metre;
    half_width = 0.5 * max(wanted, kLeastPixels);
    // A line thinner than it can be drawn fades instead; cracks seen edge-on fade as well.
    strength = clamp(0.35 + 0.65 * wanted / kLeastPixels, 0.0, 1.0) * smoothstep(0.02, 0.25, dot(normal, to_eye))
               * (1.0 - smoothstep(kFullUpTo * width, kGoneAt * width, opening));
    across = (half_width + 1.0) * float(2 * (gl_VertexID & 1) - 1);
    vec2 offset = vec2(-along.y, along.x) * across + along * (end == 0 ? -0.5 : 0.5) * half_width;
    gl_Position = clip[end];
    gl_Position.xy += offset * 2.0 * frame.viewport.zw * clip[end].w;
    if (clip[0].w <= frame.depth_range.x || clip[1].w <= frame.depth_range.x) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
