// SPDX-License-Identifier: Apache-2.0
// Grains of grit: bent cubes, each of its own shape and thickness.
#include "common/rotate.glsl"
#include "common/grain_draw.glsl"
struct Grain {
    vec4 position_size;  // m; size 0: there is none
    uvec2 turn;          // quaternion, 4 x snorm16; of a spark its velocity, m/s, and its age, s, 4 x half
    uint seed;
    float heat;          // 0: grit; of a spark 1 as it is born
};
layout(std430, binding = GRAIN_BINDING) readonly buffer Grains { Grain grains[]; };
const uint kGrainFaces = 12u, kGrainNames = 16u;  // of a grain; names to each

// Thinner one way than the others.
vec3 grainShape(uint seed) {
    return vec3(1.0, 0.6 + 0.4 * grainDraw(seed + 1001u), 0.35 + 0.5 * grainDraw(seed + 2003u));
}

// Of a grain of size 1: one of eight, by the signs of its place, each moved off its own way.
vec3 bentCorner(uint seed, int corner) {
    uint own = seed + 17u * uint(corner);
    vec3 bend = vec3(grainDraw(own), grainDraw(own + 5u), grainDraw(own + 11u));
    vec3 side = vec3(1 - 2 * (corner & 1), 1 - (corner & 2), 1 - ((corner & 4) >> 1));
    return side * (0.13 + 0.26 * bend);
}

// Below this a grain would be thinner than a pixel of the picture: it is drawn that large, and fewer of them.
const float kLeastGrainPixels = 1.3;

// Width of a pixel where it is, m.
float pixelAtGrain(Grain g) {
    float along = dot(g.position_size.xyz - frame.eye.xyz, frame.ray_forward.xyz);
    return 2.0 * frame.depth_range.z * frame.viewport.w * max(along, 0.0);
}

// Factor by which a grain is enlarged; 0: it is one of those left out instead, or a spark.
float grainGrowth(Grain g) {
    if (g.position_size.w <= 0.0 || g.heat > 0.0) return 0.0;
    float pixel = pixelAtGrain(g);
    float grow = max(1.0, kLeastGrainPixels * pixel / max(g.position_size.w, 1e-12));
    return grainDraw(g.seed + 77u) * grow * grow > 1.0 && grow > 1.0 ? 0.0 : grow;
}

struct GrainFace {
    vec3 corner[3];  // of a grain of size 1, turned; counter-clockwise from outside
    vec3 normal;     // unit
};

vec4 grainTurn(Grain g) {
    vec4 turn = vec4(unpackSnorm2x16(g.turn.x), unpackSnorm2x16(g.turn.y));
    return normalize(turn + vec4(0.0, 0.0, 0.0, 1e-9));
}

GrainFace turnedFace(Grain g, vec3 a, vec3 b, vec3 c) {
    vec4 turn = grainTurn(g);
    vec3 shape = grainShape(g.seed);
    GrainFace f;
    f.corner = vec3[](rotate(turn, shape * a), rotate(turn, shape * b), rotate(turn, shape * c));
    f.normal = normalize(cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]));
    return f;
}

// Half of one of six sides: of axis face / 4, the one or the other.
GrainFace grainFace(Grain g, int face) {
    int axis = face / 4, along = 1 << (axis + 1) % 3, across = 1 << (axis + 2) % 3, low = (face >> 1 & 1) << axis;
    int second = (face & 1) == 0 ? along : along | across, third = (face & 1) == 0 ? along | across : across;
    vec3 a = bentCorner(g.seed, low), b = bentCorner(g.seed, low | second), c = bentCorner(g.seed, low | third);
    return low == 0 ? turnedFace(g, a, b, c) : turnedFace(g, a, c, b);
}

#ifdef BODY_MATERIAL
// Broken material, of some tone of its own; one in eight has kept a bit of the coat. Its faces are rough, and rounder than flat
// ones.
void grainMaterial(inout Surface s, Grain g, int face) {
    uint seed = g.seed, mixed = grainHash(seed);
    float size = max(g.position_size.w, 1e-9), pixel = pixelAtGrain(g) / size;
    vec3 away = (s.position - g.position_size.xyz) / size;
    vec4 turn = grainTurn(g), back = vec4(-turn.xyz, turn.w);
    vec3 at = rotate(back, away) + grainDraw(seed + 41u);
    vec4 coarse = noiseOver(2.5 * at, 2.5 * pixel), fine = noiseOver(7.0 * (kTurn1 * at), 7.0 * pixel);
    vec3 slope = rotate(turn, coarse.xyz + 0.8 * (transpose(kTurn1) * fine.xyz));
    s.normal = normalize(s.geometric_normal + away);
    s.normal = normalize(s.normal - 0.35 * (slope - s.normal * dot(slope, s.normal)));
    float tone = float((mixed >> 8) & 255u) / 255.0;
    bool coat = (mixed & 7u) == 0u && uint(face) == ((mixed >> 4) & 7u);
    vec3 broken = grainDraw(seed + 31u) < texture_colour.a ? texture_colour.rgb : inside.rgb;
    s.albedo = coat ? outside.rgb : broken * (0.8 + 0.35 * tone) * (1.0 + 0.25 * coarse.w + 0.2 * fine.w);
    s.roughness = coat ? outside.a : 0.92;
}
#endif
