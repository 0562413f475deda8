#version 450 core
// Resolve: darkens ambient light by occlusion, maps each sample to display range, averages, encodes sRGB. Mapping before
// averaging keeps edges between bright and dark smooth.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#if SAMPLES > 1
layout(binding = 0) uniform sampler2DMS hdr;
layout(binding = 1) uniform sampler2DMS depth_buffer;
#else
layout(binding = 0) uniform sampler2D hdr;
layout(binding = 1) uniform sampler2D depth_buffer;
#endif
layout(binding = 2) uniform sampler2D occlusion;  // half size; r: visibility, g: linear depth
layout(rgba8, binding = 0) writeonly uniform image2D result;
layout(location = 0) uniform vec4 curve;  // contrast, shoulder, b, c: y = x^contrast gives y / (y^shoulder b + c)
layout(location = 1) uniform int has_occlusion;

// Bright saturated colours lean to white, as film does: primaries are mixed a little before the curve and unmixed after.
const float kMix = 0.09;

vec3 toneMap(vec3 c) {
    c *= frame.sun_colour.w;
    float mean = (c.r + c.g + c.b) / 3.0;
    c = max(mix(c, vec3(mean), kMix), 1e-5);
    vec3 x = pow(c, vec3(curve.x));
    c = x / (pow(x, vec3(curve.y)) * curve.z + curve.w);
    mean = (c.r + c.g + c.b) / 3.0;
    return clamp(mean + (c - mean) / (1.0 - 0.75 * kMix), 0.0, 1.0);
}

vec3 encodeSrgb(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

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

// A crevice hides part of the sun's wide disc as well, so direct light is darkened a little too.
const float kDirectShare = 0.3;

vec3 mapped(vec4 sample_value, float visibility) {
    float share = mix(kDirectShare, 1.0, sample_value.a);
    return toneMap(sample_value.rgb * (1.0 - share * (1.0 - visibility)));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result)))) return;
    vec4 first = texelFetch(hdr, pixel, 0);
    float visibility = 1.0;
    if (has_occlusion != 0) visibility = visibilityAt(pixel, linearDepth(texelFetch(depth_buffer, pixel, 0).r));
    vec3 c = mapped(first, visibility);
#if SAMPLES > 1
    vec4 others[SAMPLES - 1];
    bool same = true;
    for (int i = 1; i < SAMPLES; ++i) {
        others[i - 1] = texelFetch(hdr, pixel, i);
        same = same && others[i - 1] == first;
    }
    if (!same) {
        for (int i = 1; i < SAMPLES; ++i) {
            float own = visibility;
            if (has_occlusion != 0) own = visibilityAt(pixel, linearDepth(texelFetch(depth_buffer, pixel, i).r));
            c += mapped(others[i - 1], own);
        }
        c /= float(SAMPLES);
    }
#endif
    imageStore(result, pixel, vec4(encodeSrgb(c), 1.0));
}
