// SPDX-License-Identifier: Apache-2.0
// The outside as its model file says (engine/looks/look_buffers.h): materials, then triangles of the uncut mesh.
layout(std430, binding = 15) readonly buffer Looks { uint look_words[]; };
layout(binding = 16) uniform sampler2DArray small_colours;
layout(binding = 17) uniform sampler2DArray large_colours;
layout(binding = 18) uniform sampler2DArray small_numbers;
layout(binding = 19) uniform sampler2DArray large_numbers;

const uint kNoLook = 0xffffffffu, kFirstMaterial = 4u, kMaterialWords = 18u, kTriangleWords = 25u;
const int kClamp = 1, kMirror = 2;
const vec2 kDown = vec2(1.0, -1.0);
const float kBeyond = 2.0;  // triangles: so far a UV goes on past the end of its chart

// Maps of a material, in the order of its words.
const uint kBaseMap = 0u, kEmissionMap = 1u, kNormalMap = 2u, kRoughnessMap = 3u, kMetallicMap = 4u, kOcclusionMap = 5u;
// Above a material's number: for each map, whether it lies on the second set of UVs. It comes along with the triangle, since
// llvmpipe takes the level of four lanes from all of them, also from those beside the triangle that may read no buffer.
const uint kSetsFrom = 26u, kMaterialMask = 0x3ffffffu;

// Of a point of the outside.
struct Looked {
    vec4 uv;      // first set, second set
    vec4 colour;  // linear
    uint material;
};

// How UV and place change from pixel to pixel, or along two edges of a triangle.
struct Laid {
    vec4 uv_right, uv_up;
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
    uint at = look_words[0] + kTriangleWords * triangle;
    vec3 a = lookVector(at), ab = lookVector(at + 3u) - a, ac = lookVector(at + 6u) - a, from = rest - a;
    vec3 normal = cross(ab, ac);
    float squared = dot(normal, normal);
    vec2 w = squared > 1e-30 ? vec2(dot(normal, cross(from, ac)), dot(normal, cross(ab, from))) / squared : vec2(0.0);
    vec3 weights = clamp(vec3(1.0 - w.x - w.y, w), -kBeyond, 1.0 + kBeyond), held = max(weights, 0.0);
    held /= held.x + held.y + held.z;
    Looked l;
    l.uv = vec4(0.0);
    l.colour = vec4(0.0);
    for (uint k = 0u; k < 3u; ++k) {
        uint first = at + 9u + 4u * k;
        l.uv += weights[k] * vec4(lookNumber(first), lookNumber(first + 1u), lookNumber(first + 2u), lookNumber(first + 3u));
        l.colour += held[k] * cornerColour(at + 21u + k);
    }
    l.material = look_words[at + 24u];
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

uint materialAt(uint material) { return kFirstMaterial + kMaterialWords * (material & kMaterialMask); }
uint useOf(uint map, Looked look) { return look_words[materialAt(look.material) + 12u + map]; }

// Of the set of UVs that the map lies on.
vec2 ofSet(uint map, Looked look, vec4 uv) { return (look.material >> (kSetsFrom + map) & 1u) != 0u ? uv.zw : uv.xy; }

vec4 colourOf(uint map, Looked look, Laid l) {
    uint use = useOf(map, look);
    if (!isUsed(use)) return vec4(1.0);
    vec3 place = placeIn(use, ofSet(map, look, look.uv));
    vec2 right = kDown * ofSet(map, look, l.uv_right), up = kDown * ofSet(map, look, l.uv_up);
    return isLarge(use) ? textureGrad(large_colours, place, right, up) : textureGrad(small_colours, place, right, up);
}

vec4 numbersOf(uint map, Looked look, Laid l) {
    uint use = useOf(map, look);
    if (!isUsed(use)) return vec4(1.0);
    vec3 place = placeIn(use, ofSet(map, look, look.uv));
    vec2 right = kDown * ofSet(map, look, l.uv_right), up = kDown * ofSet(map, look, l.uv_up);
    return isLarge(use) ? textureGrad(large_numbers, place, right, up) : textureGrad(small_numbers, place, right, up);
}

float numberOf(uint map, Looked look, Laid l) { return numbersOf(map, look, l)[useOf(map, look) >> 13 & 3u]; }

vec4 baseColour(Looked look, Laid l) {
    uint m = materialAt(look.material);
    return vec4(lookVector(m), lookNumber(m + 3u)) * colourOf(kBaseMap, look, l) * look.colour;
}

// rgb: light that it sends out; a: share of the surroundings' light that its picture of occlusion leaves.
vec4 glowOf(Looked look, Laid l) {
    if (look.material == kNoLook) return vec4(0.0, 0.0, 0.0, 1.0);
    uint m = materialAt(look.material);
    vec3 emission = lookVector(m + 4u) * colourOf(kEmissionMap, look, l).rgb;
    bool is_shaded = isUsed(useOf(kOcclusionMap, look));
    float open = is_shaded ? 1.0 + lookNumber(m + 10u) * (numberOf(kOcclusionMap, look, l) - 1.0) : 1.0;
    return vec4(emission, open);
}
