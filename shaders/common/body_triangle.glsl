// SPDX-License-Identifier: Apache-2.0
// The body's triangles by number, for passes that compute instead of drawing.
#include "common/body.glsl"
#include "common/commands.glsl"
#include "common/near_faces.glsl"
layout(std430, binding = 2) readonly buffer ExteriorIndices { uint exterior_indices[]; };
layout(std430, binding = 3) readonly buffer InteriorIndices { uint interior_indices[]; };
layout(std430, binding = 4) readonly buffer ExteriorVertices { uvec2 exterior_words[]; };  // 3 pairs of words a vertex
layout(std430, binding = 5) readonly buffer InteriorVertices { uvec2 interior_words[]; };

// Names of what a sample shows: 0 nothing; triangles from 1 on, those of broken faces with the bit, near ones with two;
// projectiles with other two; grains with three: slot and face (common/grain.glsl).
const uint kInteriorBit = 0x80000000u, kNearBits = 0xa0000000u, kSphereBits = 0xc0000000u, kGrainBits = 0xe0000000u;

uint triangleCount() {
    return commands[kExteriorCommand].count / 3u + commands[kInteriorCommand].count / 3u + nearTriangles();
}

// Triangle `t` of the exterior, then the interior, then the near list.
uint nameOfTriangle(uint t) {
    uint of_outside = commands[kExteriorCommand].count / 3u, of_inside = commands[kInteriorCommand].count / 3u;
    if (t < of_outside) return t + 1u;
    t -= of_outside;
    return t < of_inside ? (t + 1u) | kInteriorBit : (t - of_inside + 1u) | kNearBits;
}

bool isInterior(uint name) { return (name & kInteriorBit) != 0u; }

struct BodyVertex {
    vec3 rest;  // m
    uint normal, place, cell;
};

BodyVertex vertexFrom(uvec2 a, uvec2 b, uvec2 c) {
    return BodyVertex(uintBitsToFloat(uvec3(a, b.x)), b.y, c.x, c.y);
}

void fetchTriangle(uint name, out BodyVertex v[3]) {
    uint first = 3u * ((name & ~kNearBits) - 1u);
    if ((name & kNearBits) == kNearBits) {
        for (uint k = 0u; k < 3u; ++k) {
            uint pair = 3u * near_indices[first + k];
            v[k] = vertexFrom(near_words[pair], near_words[pair + 1u], near_words[pair + 2u]);
        }
    } else if (isInterior(name)) {
        for (uint k = 0u; k < 3u; ++k) {
            uint pair = 3u * interior_indices[first + k];
            v[k] = vertexFrom(interior_words[pair], interior_words[pair + 1u], interior_words[pair + 2u]);
        }
    } else {
        for (uint k = 0u; k < 3u; ++k) {
            uint pair = 3u * exterior_indices[first + k];
            v[k] = vertexFrom(exterior_words[pair], exterior_words[pair + 1u], exterior_words[pair + 2u]);
        }
    }
}

FragmentTransform motionOf(BodyVertex v) { return transforms[particle_fragment[v.cell]]; }

// Corners of a triangle in the world, m.
void cornersOf(uint name, out vec3 p[3]) {
    BodyVertex v[3];
    fetchTriangle(name, v);
    for (int k = 0; k < 3; ++k) p[k] = moved(motionOf(v[k]), v[k].rest);
}
