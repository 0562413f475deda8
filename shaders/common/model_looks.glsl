// SPDX-License-Identifier: Apache-2.0
// The outside as its model file says (engine/looks/look_buffers.h): materials, then triangles of the uncut mesh.
layout(std430, binding = 15) readonly buffer Looks { uint look_words[]; };
layout(binding = 16) uniform sampler2DArray small_colours;
layout(binding = 17) uniform sampler2DArray large_colours;
layout(binding = 18) uniform sampler2DArray small_numbers;
layout(binding = 19) uniform sampler2DArray large_numbers;

const uint kNoLook = 0xffffffffu, kFirstMaterial = 4u, kLookWords = 20u;
const int kClamp = 1, kMirror = 2;
const vec2 kDown = vec2(1.0, -1.0);
const float kBeyond = 2.0;  // triangles: so far a UV goes on past the end of its chart

// Of a point of the outside.
struct Looked {
    vec2 uv;
    vec4 colour;  // linear
    uint material;
};

// How UV and place change from pixel to pixel, or along two edges of a triangle.
struct Laid {
    vec2 uv_right, uv_up;
    vec3 right, up;  // m, world
};

float lookNumber(uint at) { return uintBitsToFloat(look_words[at]); }
vec3 lookVector(uint at) { return vec3(lookNumber(at), lookNumber(at + 1u), lookNumber(at + 2u)); }

vec3 linearFrom(vec3 srgb) { return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb)); }

vec4 cornerColour(uint at) {
    vec4 colour = unpackUnorm4x8(look_words[at]);
    return vec4(linearFrom(colour.rgb), colour.a);
}

// `triangle`: of the uncut mesh; `rest`: in its plane, m.
Looked lookedAt(uint triangle, vec3 rest) {
    uint at = look_words[0] + kLookWords * triangle;
    vec3 a = lookVector(at), ab = lookVector(at + 3u) - a, ac = lookVector(at + 6u) - a, from = rest - a;
    vec3 normal = cross(ab, ac);
    float squared = dot(normal, normal);
    vec2 w = squared > 1e-30 ? vec2(dot(normal, cross(from, ac)), dot(normal, cross(ab, from))) / squared : vec2(0.0);
    vec3 weights = clamp(vec3(1.0 - w.x - w.y, w), -kBeyond, 1.0 + kBeyond), held = max(weights, 0.0);
    held /= held.x + held.y + held.z;
    Looked l;
    l.uv = vec2(0.0);
    l.colour = vec4(0.0);
    for (uint k = 0u; k < 3u; ++k) {
        l.uv += weights[k] * vec2(lookNumber(at + 9u + 2u * k), lookNumber(at + 10u + 2u * k));
        l.colour += held[k] * cornerColour(at + 15u + k);
    }
    l.material = look_words[at + 18u];
    return l;
}

float wrapped(float t, int mode) {
    if (mode == kClamp) return clamp(t, 0.001, 0.999);
    if (mode == kMirror) return 1.0 - abs(mod(t, 2.0) - 1.0);
    return t;
}

// Texture coordinates and layer; pictures begin with their upper row.
vec3 placeIn(uint use, vec2 uv) {
    return vec3(wrapped(uv.x, int(use >> 15 & 3u)), wrapped(1.0 - uv.y, int(use >> 17 & 3u)), float(use & 0xfffu));
}

bool isUsed(uint use) { return (use & 0x80000000u) != 0u; }
bool isLarge(uint use) { return (use & 0x1000u) != 0u; }

vec4 colourOf(uint use, vec2 uv, Laid l) {
    if (!isUsed(use)) return vec4(1.0);
    vec3 place = placeIn(use, uv);
    return isLarge(use) ? textureGrad(large_colours, place, kDown * l.uv_right, kDown * l.uv_up) : textureGrad(small_colours, place, kDown * l.uv_right, kDown * l.uv_up);
}

vec4 numbersOf(uint use, vec2 uv, Laid l) {
    if (!isUsed(use)) return vec4(1.0);
    vec3 place = placeIn(use, uv);
    return isLarge(use) ? textureGrad(large_numbers, place, kDown * l.uv_right, kDown * l.uv_up) : textureGrad(small_numbers, place, kDown * l.uv_right, kDown * l.uv_up);
}

float numberOf(uint use, vec2 uv, Laid l) { return numbersOf(use, uv, l)[use >> 13 & 3u]; }

uint materialAt(uint material) { return kFirstMaterial + kLookWords * material; }

vec4 baseColour(Looked look, Laid l) {
    uint m = materialAt(look.material);
    return vec4(lookVector(m), lookNumber(m + 3u)) * colourOf(look_words[m + 12u], look.uv, l) * look.colour;
}

bool isCutOut(Looked look, Laid l) {
    if (look.material == kNoLook) return false;
    float cutoff = lookNumber(materialAt(look.material) + 11u);
    return cutoff > 0.0 && baseColour(look, l).a < cutoff;
}

// rgb: light that it sends out; a: share of the surroundings' light that its picture of occlusion leaves.
vec4 glowOf(Looked look, Laid l) {
    if (look.material == kNoLook) return vec4(0.0, 0.0, 0.0, 1.0);
    uint m = materialAt(look.material);
    uint occlusion = look_words[m + 17u];
    vec3 emission = lookVector(m + 4u) * colourOf(look_words[m + 13u], look.uv, l).rgb;
    float open = isUsed(occlusion) ? 1.0 + lookNumber(m + 10u) * (numberOf(occlusion, look.uv, l) - 1.0) : 1.0;
    return vec4(emission, open);
}
