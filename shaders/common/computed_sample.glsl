// SPDX-License-Identifier: Apache-2.0
// What a sample shows, from its name: the triangle is fetched again and its material made here, once for all samples of a
// pixel that show it.
#include "common/body_triangle.glsl"
#include "common/visible.glsl"
#include "common/ball.glsl"
#include "common/noise.glsl"
#include "common/crack_colour.glsl"
#define BODY_MATERIAL 8
#include "common/body_material.glsl"
#define GRAIN_BINDING 12
#include "common/grain.glsl"

const bool kShowsBodies = true;

float depthAt(ivec2 pixel, int i) { return uintBitsToFloat(visible[sampleIndex(pixel, SAMPLES, i)]); }

uint nameAt(ivec2 pixel, int i) { return visible[sampleTotal(SAMPLES) + sampleIndex(pixel, SAMPLES, i)]; }

uint crackStepsAt(ivec2 pixel, int i) { return (visible[crackWord(pixel, SAMPLES, i)] >> (16 * (i & 1))) & 0xffffu; }

// Equal for samples that look alike; z is never that of floor or sky.
uvec3 valueAt(ivec2 pixel, int i) { return uvec3(nameAt(pixel, i), crackStepsAt(pixel, i), 1u); }

// A triangle in the world.
struct Corners {
    vec3 first, to_1, to_2;  // m
};

// Weights of the second and third corner where a ray from the eye meets the triangle's plane.
vec2 weightsAt(Corners c, vec3 ray) {
    vec3 from = frame.eye.xyz - c.first, across = cross(ray, c.to_2);
    float area = dot(c.to_1, across);
    return vec2(dot(from, across), dot(ray, cross(from, c.to_1))) / (abs(area) > 1e-30 ? area : 1e-30);
}

// The nearest weights that are inside.
vec3 nearestInside(vec2 w) {
    vec3 weights = max(vec3(1.0 - w.x - w.y, w), 0.0);
    return weights / (weights.x + weights.y + weights.z);
}

void makeBody(ivec2 pixel, uint name, inout Surface s) {
    BodyVertex v[3];
    fetchTriangle(name, v);
    FragmentTransform t = motionOf(v[0]);  // all corners are of one fragment
    vec3 first = moved(t, v[0].rest);
    Corners corners = Corners(first, moved(t, v[1].rest) - first, moved(t, v[2].rest) - first);
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
        vec2 of_corner = unpackHalf2x16(v[k].uv);
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
    uint slot = (name & ~kGrainBits) / kGrainFaces;
    int face = int(name % kGrainFaces);
    GrainFace f = grainFace(grains[slot], face);
    s.geometric_normal = f.normal;
    s.normal = f.normal;
    s.metalness = 0.0;
    grainMaterial(s, grains[slot].seed, face);
}

// `position`: of the sample, m.
Surface surfaceAt(ivec2 pixel, int i, vec3 position) {
    uint name = nameAt(pixel, i), steps = crackStepsAt(pixel, i);
    Surface s;
    s.position = position;
    if ((name & kGrainBits) == kGrainBits) makeGrain(name, s);
    else if ((name & kSphereBits) == kSphereBits) makeBall(pixel, name, s);
    else makeBody(pixel, name, s);
    if (steps == 0u) return s;
    float left = exp2(-float(steps) / kCrackSteps);
    vec3 root = mix(kCrackColour, sqrt(clamp(s.albedo, 0.0, 1.0)), left);
    s.albedo = root * root;
    s.roughness = mix(1.0, s.roughness, left);
    s.metalness *= step(0.5, left);
    return s;
}
