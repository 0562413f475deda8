// SPDX-License-Identifier: Apache-2.0
// What a sample shows, from its name: the triangle is fetched again and its material made here, once for all samples of a
// pixel that show it.
#include "common/body_triangle.glsl"
#include "common/corner_weights.glsl"
#include "common/visible.glsl"
#include "common/ball.glsl"
#include "common/noise.glsl"
#include "common/crack_colour.glsl"
#define BODY_MATERIAL 8
#include "common/body_material.glsl"
#define GRAIN_BINDING 12
#include "common/grain.glsl"

#ifdef LOOKS
#include "common/model_material.glsl"
#endif

const bool kShowsBodies = true;

float depthAt(ivec2 pixel, int i) { return uintBitsToFloat(depthOfSample(sampleIndex(pixel, SAMPLES, i))); }

uint nameAt(ivec2 pixel, int i) { return visible[nameWord(sampleIndex(pixel, SAMPLES, i))]; }

uint cracksAt(ivec2 pixel, int i) { return visible[crackWord(pixel, SAMPLES, i)]; }

// Equal for samples that look alike; z is never that of floor or sky.
uvec3 valueAt(ivec2 pixel, int i) { return uvec3(nameAt(pixel, i), cracksAt(pixel, i), 1u); }

#ifdef LOOKS
const float kLookStep = 1.0 / 16.0;  // px: a whole one leaves what is seen aslant

// As its model file says. `ray`: through the middle of the pixel; `w`: weights of the second and third corner there.
void lookOutside(BodyVertex v[3], Corners corners, vec3 weights, vec3 ray, vec2 w, inout Surface s) {
    vec2 right = (weightsAt(corners, ray + 2.0 * kLookStep * frame.viewport.z * frame.ray_right.xyz) - w) / kLookStep;
    vec2 up = (weightsAt(corners, ray + 2.0 * kLookStep * frame.viewport.w * frame.ray_up.xyz) - w) / kLookStep;
    Looked of_corner[3];
    for (int k = 0; k < 3; ++k) of_corner[k] = lookedAt(v[k].place, v[k].rest);
    if (of_corner[2].material == kNoLook) return;
    vec4 uv_1 = of_corner[1].uv - of_corner[0].uv, uv_2 = of_corner[2].uv - of_corner[0].uv;
    Looked look = of_corner[2];
    look.uv = of_corner[0].uv + weights.y * uv_1 + weights.z * uv_2;
    look.colour = weights.x * of_corner[0].colour + weights.y * of_corner[1].colour + weights.z * of_corner[2].colour;
    Laid laid = Laid(right.x * uv_1 + right.y * uv_2, up.x * uv_1 + up.y * uv_2, right.x * corners.to_1 + right.y * corners.to_2,
                     up.x * corners.to_1 + up.y * corners.to_2);
    modelMaterial(s, look, laid);
#ifdef GLOW
    s.glow = glowOf(look, laid);
#endif
}
#endif

void makeBody(ivec2 pixel, uint name, inout Surface s) {
    BodyVertex v[3];
    fetchTriangle(name, v);
    FragmentTransform t = motionOf(v[0]);  // all corners are of one fragment
    Corners corners = cornersIn(v, t);
    // As a drawing pass has it: in the middle of the pixel, but never off the triangle.
    vec3 ray = rayThrough(vec2(pixel) + 0.5);
    vec2 w = weightsAt(corners, ray);
    vec2 right = weightsAt(corners, ray + 2.0 * frame.viewport.z * frame.ray_right.xyz) - w;
    vec2 up = weightsAt(corners, ray + 2.0 * frame.viewport.w * frame.ray_up.xyz) - w;
    vec3 weights = nearestInside(w), normal = vec3(0.0), at_rest = vec3(0.0);
    vec2 relief = vec2(0.0), deeper = vec2(0.0);
    for (int k = 0; k < 3; ++k) {
        at_rest += weights[k] * v[k].rest;
        normal += weights[k] * decodeOctahedral(unpackSnorm2x16(v[k].normal));
        vec2 of_corner = unpackHalf2x16(v[k].place);
        relief += weights[k] * of_corner;
        deeper += of_corner.x * (k == 0 ? vec2(-right.x - right.y, -up.x - up.y) : vec2(right[k - 1], up[k - 1]));
    }
    mat2x3 edges = mat2x3(v[1].rest - v[0].rest, v[2].rest - v[0].rest);
    noise_footprint = max(length(edges * right), length(edges * up));
    s.geometric_normal = normalize(rotate(t.rotation, normal));
    s.normal = s.geometric_normal;
    s.metalness = 0.0;
    if (isInterior(name)) insideMaterial(s, at_rest, t.rotation, relief, coatAt(relief.x, edges * right, edges * up, deeper));
    else outsideMaterial(s, at_rest);
#ifdef LOOKS
    if (!isInterior(name)) lookOutside(v, corners, weights, ray, w, s);
#endif
    turnToEye(s);
}

void makeBall(ivec2 pixel, uint name, inout Surface s) {
    vec4 ball = balls[name & ~kSphereBits].position_radius;
    s.normal = normalize(s.position - ball.xyz);
    s.geometric_normal = s.normal;
    s.albedo = kBallAlbedo;
    s.roughness = kBallRoughness;
    s.metalness = 1.0;
}

void makeGrain(uint name, inout Surface s) {
    uint slot = (name & ~kGrainBits) / kGrainNames;
    int face = int(name % kGrainNames);
    GrainFace f = grainFace(grains[slot], face);
    s.geometric_normal = f.normal;
    s.normal = f.normal;
    s.metalness = 0.0;
    grainMaterial(s, grains[slot], face);
}

// `position`: of the sample, m.
Surface surfaceAt(ivec2 pixel, int i, vec3 position) {
    uint name = nameAt(pixel, i), cracks = cracksAt(pixel, i);
    Surface s;
    s.position = position;
#ifdef GLOW
    s.glow = kNoGlow;
#endif
    if ((name & kGrainBits) == kGrainBits) makeGrain(name, s);
    else if ((name & kSphereBits) == kSphereBits) makeBall(pixel, name, s);
    else makeBody(pixel, name, s);
    if (cracks == 0u) return s;
    float left = exp2(-float(cracks & 0xffffu) / kCrackSteps), hides = 1.0 - left;
    CrackCover cover = CrackCover(hides, min(float(cracks >> 16) / kWallSteps, hides));
    vec3 root = mix(crackRoot(cover, sqrt(inside.rgb)), sqrt(clamp(s.albedo, 0.0, 1.0)), left);
    s.albedo = root * root;
    s.roughness = mix(1.0, s.roughness, left);
    s.metalness *= step(0.5, left);
    return s;
}
