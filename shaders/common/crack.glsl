// SPDX-License-Identifier: Apache-2.0
// Hairlines along edges of the outside: a ribbon widened on the screen, at least kLeastPixels wide and soft at its rim;
// wider and narrower, darker and lighter along its way. Where the two cells belong to different fragments it fades as they
// part: then the gap itself is what one sees.
struct CrackEdge {
    uint vertex_0, vertex_1;  // exterior vertices of cell_a
    uint cell_a, cell_b;
    uint bond;
};
layout(std430, binding = 3) readonly buffer CrackList { uint crack_list[]; };  // crackWord() of api/render_streams.h
layout(std430, binding = 4) readonly buffer CrackEdges { CrackEdge crack_edges[]; };
layout(std430, binding = 5) readonly buffer ExteriorVertices { uint exterior_words[]; };  // 6 words a vertex
layout(location = 0) uniform float width;  // m

const uint kCrackEdgeBits = 26u, kTaperBits = 3u, kTaperSteps = 7u;
const float kLeastPixels = 1.3;
const float kFullUpTo = 0.5, kGoneAt = 3.0;  // opening gap, in widths

uint crackEdgeOf(uint word) { return word & ((1u << kCrackEdgeBits) - 1u); }

// Share of the whole width: hairlines end in nothing.
float taperOf(uint word, int end) {
    uint lacking = word >> (kCrackEdgeBits + uint(end) * kTaperBits) & kTaperSteps;
    return 1.0 - float(lacking) / float(kTaperSteps);
}

vec3 restPosition(uint vertex) {
    uint word = 6u * vertex;
    return uintBitsToFloat(uvec3(exterior_words[word], exterior_words[word + 1u], exterior_words[word + 2u]));
}

vec3 restNormal(uint vertex) { return decodeOctahedral(unpackSnorm2x16(exterior_words[6u * vertex + 3u])); }

// How far two fragments have carried a point of their common border apart, m.
float openingAt(vec3 p, FragmentTransform t, uint fragment, uint other) {
    return fragment == other ? 0.0 : distance(moved(t, p), moved(transforms[other], p));
}

// Lifts the line off the surface: a little outward, and towards the camera by what the ribbon's slope needs.
vec3 lifted(vec3 p, vec3 normal, vec3 to_eye) { return p + 0.25 * width * normal + 0.75 * width * to_eye; }

// px, at a depth of `w` m.
float widthOnScreen(float w) {
    return width * frame.viewport.y / (2.0 * frame.depth_range.z * max(w, frame.depth_range.x));
}

// A line thinner than it can be drawn fades instead; cracks seen edge-on fade as well, and hairlines towards their ends.
float strengthOf(float wanted, float taper, float facing, float opening) {
    return min(2.0 * taper, 1.0) * clamp(0.35 + 0.65 * wanted / kLeastPixels, 0.0, 1.0) * smoothstep(0.02, 0.25, facing) *
           (1.0 - smoothstep(kFullUpTo * width, kGoneAt * width, opening));
}
