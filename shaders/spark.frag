// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Light that a spark adds: its disc spread over its way, less towards the tail. Behind what is solid it is not seen.
#include "common/choices.glsl"
#include "common/frame.glsl"
#include "common/tone.glsl"
#include "common/solid.glsl"
#include "common/grain_draw.glsl"
#include "common/spark.glsl"
noperspective in vec2 place;
flat in Spark spark;
layout(location = 0) out vec4 colour;

const int kRays = 7;
const float kRayLight = 0.06;  // of the disc's

// Soft at its rim, so that a thin streak has no steps.
float across(float pixels, float radius) {
    float share = pixels / radius;
    return exp2(-1.7 * share * share);
}

// Share of the time for which the disc stood here, times the film's weight of that time.
float streakAt(vec2 at) {
    float radius = max(spark.streak.y, kLeastSparkRadius);
    float way = max(spark.streak.x, 1e-3), whole = max(spark.streak.z, 1e-3);
    float first = clamp(at.x - radius, 0.0, way), last = clamp(at.x + radius, 0.0, way);
    float opened = mix(spark.taper.x, spark.taper.y, 0.5 * (first + last) / way);
    float thin = spark.streak.y * mix(0.35, 1.0, opened), wide = max(thin, kLeastSparkRadius);
    return 2.0 * opened * (last - first) / whole * clamp(thin / wide, 0.15, 1.0) * across(at.y, wide);
}

float burstAt(vec2 at) {
    if (spark.streak.w <= 0.0) return 0.0;
    float sum = 0.0;
    for (int k = 0; k < kRays; ++k) {
        uint own = spark.seed + 41u * uint(k + 1);
        float turn = 6.2831853 * (float(k) + grainDraw(own)) / float(kRays);
        vec2 ray = vec2(cos(turn), sin(turn));
        float share = dot(at, ray) / (spark.streak.w * (0.35 + 0.65 * grainDraw(own + 7u)));
        if (share < 0.0 || share > 1.0) continue;
        sum = max(sum, (1.0 - share) * across(dot(at, vec2(-ray.y, ray.x)), kLeastSparkRadius));
    }
    return kRayLight * sum;
}

void main() {
    vec3 ray = rayThrough(gl_FragCoord.xy);
    if (1.0 / gl_FragCoord.w > 1.002 * solidAlong(gl_FragCoord.xy, ray)) discard;
    vec3 light = (streakAt(place) + burstAt(place - vec2(spark.streak.x, 0.0))) * spark.light;
#ifdef RADIANCE
    colour = vec4(light, clamp(max(light.r, max(light.g, light.b)), 0.0, 1.0));  // before nothing it is seen as far as it is bright
#else
    colour = vec4(encodeSrgb(toneMap(light * frame.exposure.rgb)), 0.0);
#endif
}
