// The body's triangles by number, for passes that compute instead of drawing.
#include "common/body.glsl"
#include "common/commands.glsl"
layout(std430, binding = 2) readonly buffer ExteriorIndices { uint exterior_indices[]; };
layout(std430, binding = 3) readonly buffer InteriorIndices { uint interior_indices[]; };
layout(std430, binding = 4) readonly buffer ExteriorVertices { uint exterior_words[]; };  // 6 words a vertex
layout(std430, binding = 5) readonly buffer InteriorVertices { uint interior_words[]; };

// Names of what a sample shows: 0 nothing; triangles from 1 on, those of broken faces with the bit; projectiles with both.
const uint kInteriorBit = 0x80000000u, kSphereBits = 0xc0000000u;

uint triangleCount() { return commands[kExteriorCommand].count / 3u + commands[kInteriorCommand].count / 3u; }

// Triangle `t` of the exterior and then the interior list.
uint nameOfTriangle(uint t) {
    uint outside = commands[kExteriorCommand].count / 3u;
    return t < outside ? t + 1u : (t - outside + 1u) | kInteriorBit;
}

bool isInterior(uint name) { return (name & kInteriorBit) != 0u; }

// First words of the corners' vertices.
uvec3 cornerWords(uint name) {
    uint first = 3u * ((name & ~kInteriorBit) - 1u);
    return 6u * (isInterior(name) ? uvec3(interior_indices[first], interior_indices[first + 1u], interior_indices[first + 2u])
                                  : uvec3(exterior_indices[first], exterior_indices[first + 1u], exterior_indices[first + 2u]));
}

uint vertexWord(uint name, uint word) { return isInterior(name) ? interior_words[word] : exterior_words[word]; }

vec3 restOf(uint name, uint word) {
    return uintBitsToFloat(uvec3(vertexWord(name, word), vertexWord(name, word + 1u), vertexWord(name, word + 2u)));
}

// All corners of a triangle are of one fragment; their cells may differ.
FragmentTransform motionOf(uint name, uint word) { return transforms[particle_fragment[vertexWord(name, word + 5u)]]; }

void cornersOf(uint name, out vec3 p[3]) {
    uvec3 words = cornerWords(name);
    for (int k = 0; k < 3; ++k) p[k] = moved(motionOf(name, words[k]), restOf(name, words[k]));
}
