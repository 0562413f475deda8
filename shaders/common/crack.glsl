// SPDX-License-Identifier: Apache-2.0
// Hairlines along edges of the outside: a ribbon as wide as the crack has opened. Where the two cells belong to different
// fragments it fades as they part: then the gap itself is what one sees. After common/noise.glsl and
// common/crack_cover.glsl.
struct CrackEdge {
    uint vertex_0, vertex_1;  // exterior vertices of cell_a
    uint cell_a, cell_b;
    uint bond;
};
struct CrackLine {
    uint edge;
    uint widths;  // m, at both ends
};
layout(std430, binding = 3) readonly buffer CrackList { CrackLine crack_list[]; };
layout(std430, binding = 4) readonly buffer CrackEdges { CrackEdge crack_edges[]; };
layout(std430, binding = 5) readonly buffer ExteriorVertices { uint exterior_words[]; };  // 6 words a vertex
layout(location = 0) uniform float width;  // m, at most, of lines between fragments

const float kLeastPixels = 1.3;               // drawn so wide at least: what is thinner fades
const float kWidest = 2.5;                    // in widths, inside of a fragment: what gapes is no line
const float kNarrow = 1.1, kUneven = 1.3;     // times the noise's strength: how much of its width a line lacks
const float kUnevenWave = 14.0;               // in widths
const float kLeastShare = 0.15;
const float kFullUpTo = 0.5, kGoneAt = 3.0;    // opening gap, in widths

// m, at an end.
float widthAt(CrackLine line, int end, bool apart) {
    vec2 widths = unpackHalf2x16(line.widths);
    return min(end == 0 ? widths.x : widths.y, apart ? width : kWidest * width);
}

// Share of its width that a crack is seen to have. Broken faces that are rough touch here and gape there: an even line looks
// drawn.
float gapingShare(vec3 rest) {
    float touches = kNarrow + kUneven * noiseOver(rest / (kUnevenWave * width), 0.0).w;
    return clamp(1.0 - noise_shape.y * touches, kLeastShare, 1.0);
}

vec3 restPosition(uint vertex) {
    uint word = 6u * vertex;
    return uintBitsToFloat(uvec3(exterior_words[word], exterior_words[word + 1u], exterior_words[word + 2u]));
}

vec3 restNormal(uint vertex) { return decodeOctahedral(unpackSnorm2x16(exterior_words[6u * vertex + 3u])); }

// Where a point of a crack is seen: between the places to which the fragments on both sides have carried it. Lines that
// follow each other name these fragments in any order.
struct CrackPoint {
    vec3 middle;
    float opening;  // m
};
CrackPoint crackPoint(vec3 p, FragmentTransform one, FragmentTransform other) {
    vec3 here = moved(one, p), there = moved(other, p);
    return CrackPoint(0.5 * (here + there), distance(here, there));
}

// Lifts the line off the surface: a little outward, and towards the camera by what the ribbon's slope needs.
vec3 lifted(vec3 p, vec3 normal, vec3 to_eye) { return p + 0.25 * width * normal + 0.75 * width * to_eye; }

// px, of `wide` m at a depth of `w` m.
float onScreen(float wide, float w) {
    return wide * frame.viewport.y / (2.0 * frame.depth_range.z * max(w, frame.depth_range.x));
}

// Along a surface with this normal, of length 1 or 0.
vec3 leftOf(vec3 along, vec3 normal) {
    vec3 left = cross(normal, along);
    return left / max(length(left), 1e-20);
}

// Tangent of the angle by which the eye looks at a line from its left.
float slantOf(vec3 left, vec3 normal, vec3 to_eye) { return dot(left, to_eye) / max(dot(normal, to_eye), 0.1); }

// A line thinner than it can be drawn fades instead; cracks seen edge-on fade as well.
float strengthOf(float wanted, float facing, float opening) {
    return clamp(wanted / kLeastPixels, 0.0, 1.0) * smoothstep(0.02, 0.25, facing) *
           (1.0 - smoothstep(kFullUpTo * width, kGoneAt * width, opening));
}
