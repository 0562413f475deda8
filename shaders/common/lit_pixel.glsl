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

#ifdef GLASS
bool showsDust() { return false; }  // the glass comes between
#else
bool showsDust() { return dustIsSeen(); }
#endif

// What lies between the eye and a sample, and how much of the surroundings it sees.
struct Before {
    vec4 dust;         // as dustOf() has it
    float visibility;  // 0..1
};

// The four texels of a smaller picture round a pixel, `size` times as large as one; corner k is first + (k & 1, k >> 1).
struct Around {
    ivec2 first;
    vec2 share;  // of the last
};
Around around(ivec2 pixel, float size) {
    vec2 place = (vec2(pixel) + 0.5) / size - 0.5;
    return Around(ivec2(floor(place)), fract(place));
}
float nearness(Around a, int k) {
    vec2 bilinear = mix(1.0 - a.share, a.share, vec2(k & 1, k >> 1));
    return bilinear.x * bilinear.y + 0.01;
}
ivec2 texelAround(Around a, int k, ivec2 size) { return clamp(a.first + ivec2(k & 1, k >> 1), ivec2(0), size - 1); }

// Shares of the depth that tell surfaces apart: for occlusion, and for dust, which would show every texel on floors seen aslant.
const float kSameSurface = 0.002, kSameDust = 0.02;

// `off`: what the depth of a texel is off by, as a share.
float dustWeight(float off) { return 1.0 / (kSameDust * kSameDust + off * off); }

#ifdef SHADOW_DRAFT
// Blended whatever the texels show: asking their depths costs a draft a tenth of its light.
Before beforeSample(ivec2 pixel, float depth) { return Before(showsDust() ? dustBefore(pixel) : vec4(0.0), 1.0); }
#else
layout(binding = 6) uniform sampler2D occlusion;  // half size, as the sums of dust; r: visibility, g: linear depth

// Texels count the more the nearer they are and the better their depth agrees with that of the sample, `depth`, m: or the
// outline of what stands before dust would have steps as large as they.
Before beforeSample(ivec2 pixel, float depth) {
    Around a = around(pixel, 2.0);
    float visibility = 0.0, weights = 0.0, dust_weights = 0.0;
    vec4 dust = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 texel = texelAround(a, k, textureSize(occlusion, 0));
        vec2 t = texelFetch(occlusion, texel, 0).rg;
        float off = abs(t.g - depth) / depth, weight = nearness(a, k) / (kSameSurface + off);
        visibility += weight * t.r;
        weights += weight;
        if (!showsDust()) continue;
        float dust_weight = nearness(a, k) * dustWeight(off);
        dust += dust_weight * texelFetch(dust_sums, texel, 0);
        dust_weights += dust_weight;
    }
    return Before(showsDust() ? dustOf(dust / dust_weights) : vec4(0.0), visibility / weights);
}
#endif

// Of what is not sky: radiance times alpha, and alpha.
vec4 litSurface(ivec2 pixel, int i, vec3 ray, int kind, float along, vec4 face, float visibility) {
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
        return shadowOver(ray, lightLeft(s, visibility, vec2(pixel)));
#endif
    }
    return vec4(throughAir(shade(s, visibility, vec2(pixel)), position), 1.0);
}

// Likewise of any sample, with the dust before it.
vec4 lit(ivec2 pixel, int i) {
    vec3 ray = rayOf(pixel, i);
    float along;
    vec4 face;
    int kind = kindOf(pixel, i, ray, along, face);
    Before before = Before(vec4(0.0), 1.0);
    if (kind != kSky || showsDust()) before = beforeSample(pixel, min(along, frame.depth_range.y));
    vec4 light = kind == kSky ? nothingSeen(ray) : litSurface(pixel, i, ray, kind, along, face, before.visibility);
    return before.dust + (1.0 - before.dust.a) * light;
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
    vec4 sum = vec4(0.0);
    // A loop, not a branch for each sample: where lanes run in step it ends when the last pixel is done, mostly after one.
    for (uint left = distinctSamples(pixel); left != 0u;) {
        int i = findLSB(left) / 4;
        sum += float((left >> (4 * i)) & 15u) * taken(lit(pixel, i));
        left &= ~(15u << (4 * i));
    }
    return finished(sum / float(SAMPLES));
}
