// SPDX-License-Identifier: Apache-2.0
// Grains of grit: bent octahedra, each of its own shape and thickness.
#include "common/rotate.glsl"
#include "common/grain_draw.glsl"
struct Grain {
    vec4 position_size;  // m; size 0: there is none
    uvec2 turn;          // quaternion, 4 x snorm16; of a spark its velocity, m/s, and its age, s, 4 x half
    uint seed;
    float heat;          // 0: grit; of a spark 1 as it is born
};
layout(std430, binding = GRAIN_BINDING) readonly buffer Grains { Grain grains[]; };
const uint kGrainFaces = 8u;

// Thinner one way than the others.
vec3 grainShape(uint seed) {
    return vec3(1.0, 0.6 + 0.4 * grainDraw(seed + 1001u), 0.35 + 0.5 * grainDraw(seed + 2003u));
}

// Moved off its place by up to half the way to its neighbours; of a grain of size 1.
vec3 bentCorner(uint seed, uint corner, vec3 place) {
    uint own = seed + 17u * corner;
    vec3 bend = vec3(grainDraw(own), grainDraw(own + 5u), grainDraw(own + 11u)) - 0.5;
    return place * (0.3 + 0.3 * grainDraw(own + 3u)) + 0.42 * (bend - place * dot(place, bend));
}

// Below this a grain would be thinner than a pixel of the picture: it is drawn that large, and fewer of them.
const float kLeastGrainPixels = 1.3;

// Factor by which a grain is enlarged; 0: it is one of those left out instead, or a spark.
float grainGrowth(Grain g) {
    if (g.position_size.w <= 0.0 || g.heat > 0.0) return 0.0;
    float along = dot(g.position_size.xyz - frame.eye.xyz, frame.ray_forward.xyz);
    float pixel = 2.0 * frame.depth_range.z * frame.viewport.w * max(along, 0.0);
    float grow = max(1.0, kLeastGrainPixels * pixel / max(g.position_size.w, 1e-12));
    return grainDraw(g.seed + 77u) * grow * grow > 1.0 && grow > 1.0 ? 0.0 : grow;
}

struct GrainFace {
    vec3 corner[3];  // of a grain of size 1, turned; counter-clockwise from outside
    vec3 normal;     // unit
};

GrainFace turnedFace(Grain g, vec3 a, vec3 b, vec3 c) {
    vec4 turn = vec4(unpackSnorm2x16(g.turn.x), unpackSnorm2x16(g.turn.y));
    turn = normalize(turn + vec4(0.0, 0.0, 0.0, 1e-9));
    vec3 shape = grainShape(g.seed);
    GrainFace f;
    f.corner = vec3[](rotate(turn, shape * a), rotate(turn, shape * b), rotate(turn, shape * c));
    f.normal = normalize(cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]));
    return f;
}

// One of eight: an octant.
GrainFace grainFace(Grain g, int face) {
    vec3 s = vec3(1 - 2 * (face & 1), 1 - (face & 2), 1 - ((face & 4) >> 1));
    vec3 a = bentCorner(g.seed, s.x < 0.0 ? 1u : 0u, vec3(s.x, 0.0, 0.0));
    vec3 b = bentCorner(g.seed, s.y < 0.0 ? 3u : 2u, vec3(0.0, s.y, 0.0));
    vec3 c = bentCorner(g.seed, s.z < 0.0 ? 5u : 4u, vec3(0.0, 0.0, s.z));
    return s.x * s.y * s.z > 0.0 ? turnedFace(g, a, b, c) : turnedFace(g, a, c, b);
}

#ifdef BODY_MATERIAL
// Broken material, of some tone of its own; one in eight has kept a bit of the coat.
void grainMaterial(inout Surface s, uint seed, int face) {
    uint mixed = grainHash(seed);
    float tone = float((mixed >> 8) & 255u) / 255.0;
    bool coat = (mixed & 7u) == 0u && uint(face) == ((mixed >> 4) & 7u);
    vec3 broken = grainDraw(seed + 31u) < texture_colour.a ? texture_colour.rgb : inside.rgb;
    s.albedo = coat ? outside.rgb : broken * (0.8 + 0.35 * tone);
    s.roughness = coat ? outside.a : 0.92;
}
#endif
