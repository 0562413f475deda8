// SPDX-License-Identifier: Apache-2.0
// Lights what was drawn, the floor and the sky: once for every distinct sample of a pixel, finished by common/finish.glsl.
// TRANSPARENT, with RADIANCE alone: surroundings are not seen, alpha is the share of the pixel that something covers. GLASS: a
// transparent body comes over this picture and tints the sun.
#include "common/choices.glsl"
#include "common/frame.glsl"
#include "common/shade.glsl"
#include "common/floor.glsl"
#include "common/seen.glsl"
#include "common/finish.glsl"
#include "common/dust_over.glsl"
#ifdef COLLIDERS
#include "common/collider_surface.glsl"
#endif
#if defined(COMPUTED)
#include "common/computed_sample.glsl"
#elif defined(EMPTY)
#include "common/empty_sample.glsl"
#else
#include "common/drawn_sample.glsl"
#endif
layout(location = 1) uniform vec2 sample_position[SAMPLES];  // inside the pixel, 0..1

#ifdef SHADOW_DRAFT
float visibilityAt(ivec2 pixel, float depth) { return 1.0; }
#else
layout(binding = 6) uniform sampler2D occlusion;  // half size; r: visibility, g: linear depth

// Four half-size neighbours, weighted by distance and by how well their depth agrees.
float visibilityAt(ivec2 pixel, float depth) {
    vec2 half_position = (vec2(pixel) + 0.5) * 0.5 - 0.5;
    ivec2 base = ivec2(floor(half_position));
    vec2 f = half_position - vec2(base);
    ivec2 last = textureSize(occlusion, 0) - 1;
    float sum = 0.0, weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec2 t = texelFetch(occlusion, clamp(base + corner, ivec2(0), last), 0).rg;
        vec2 bilinear = mix(1.0 - f, f, vec2(corner));
        float agree = 1.0 / (0.002 + abs(t.g - depth) / depth);
        float weight = (bilinear.x * bilinear.y + 0.01) * agree;
        sum += weight * t.r;
        weights += weight;
    }
    return sum / weights;
}
#endif

vec3 rayOf(ivec2 pixel, int i) { return rayThrough(vec2(pixel) + sample_position[i]); }

void withoutGlow(inout Surface s) {
#ifdef GLOW
    s.glow = kNoGlow;
#endif
}

// What a sample shows: all but kDrawn were not drawn, they follow from the ray.
const int kSky = 0, kFloor = 1, kDrawn = 2, kCollider = 3;

// `face`: of a collider, xyz its normal, w its number.
int kindOf(ivec2 pixel, int i, vec3 ray, out float along, out vec4 face) {
    along = floorAlong(ray);
    face = vec4(0.0);
#ifdef COLLIDERS
    Crossing solid = nearestCollider(ray);
    bool is_solid = solid.enter < along;
    if (is_solid) face = vec4(solid.normal, float(solid.solid));
    along = min(along, solid.enter);
#else
    const bool is_solid = false;
#endif
    float depth = kShowsBodies ? depthAt(pixel, i) : 0.0, drawn = depth > 0.0 ? linearDepth(depth) : kNoFloor;
    bool is_drawn = kShowsBodies && depth > 0.0 && drawn <= along;
    along = min(drawn, along);
    return is_drawn ? kDrawn : is_solid ? kCollider : along == kNoFloor ? kSky : kFloor;
}

// Radiance times alpha, and alpha.
vec4 lit(ivec2 pixel, int i) {
    vec3 ray = rayOf(pixel, i);
    float along;
    vec4 face;
    int kind = kindOf(pixel, i, ray, along, face);
    if (kind == kSky) return nothingSeen(ray);
    vec3 position = frame.eye.xyz + ray * along;
    Surface s;
    if (kShowsBodies && kind == kDrawn) {
        s = surfaceAt(pixel, i, position);
#ifdef COLLIDERS
    } else if (kind == kCollider) {
        s = shapeSurface(position, face.xyz, uint(face.w), along);
        withoutGlow(s);
#endif
    } else {
        s = floorSurface(position, ray);
        withoutGlow(s);
#if FLOOR == FLOOR_SHADOW
        return shadowOver(ray, lightLeft(s, visibilityAt(pixel, along), vec2(pixel)));
#endif
    }
    return vec4(throughAir(shade(s, visibilityAt(pixel, along), vec2(pixel)), position), 1.0);
}

// Samples that one triangle covers hold the same values, and so do those of the floor, of the sky and of a face of a collider: 4
// bits of count for each distinct one, at the place of the first like it.
uint distinctSamples(ivec2 pixel) {
    int kinds[SAMPLES];
    uint faces[SAMPLES];
    bool alike = true;
    for (int i = 0; i < SAMPLES; ++i) {
        float along;
        vec4 face;
        kinds[i] = kindOf(pixel, i, rayOf(pixel, i), along, face);
        faces[i] = packSnorm4x8(vec4(face.xyz, face.w / 127.0));
        alike = alike && kinds[i] != kDrawn && kinds[i] == kinds[0] && faces[i] == faces[0];
    }
    uint counts = uint(SAMPLES);
    // A loop in place of a branch: software renderers go through branches that no pixel takes, but not through loops.
    for (bool compare = !alike; compare; compare = false) {
        uvec3 values[SAMPLES];
        counts = 0u;
        for (int i = 0; i < SAMPLES; ++i) {
            values[i] = kinds[i] == kDrawn ? valueAt(pixel, i) : uvec3(kinds[i], faces[i], 0u);
            int first = i;
            for (int j = i - 1; j >= 0; --j) {
                if (values[i] == values[j]) first = j;
            }
            counts += 1u << (4 * first);
        }
    }
    return counts;
}

// sRGB encoded; with RADIANCE as lit() has it.
vec4 pixelColour(ivec2 pixel) {
#ifdef GLASS
    const vec4 dust = vec4(0.0);  // the glass comes between
#else
    vec4 dust = dustBefore(pixel);
#endif
    vec4 sum = vec4(0.0);
    // A loop, not a branch for each sample: where lanes run in step it ends when the last pixel is done, mostly after one.
    for (uint left = distinctSamples(pixel); left != 0u;) {
        int i = findLSB(left) / 4;
        sum += float((left >> (4 * i)) & 15u) * taken(dust + (1.0 - dust.a) * lit(pixel, i));
        left &= ~(15u << (4 * i));
    }
    return finished(sum / float(SAMPLES));
}
