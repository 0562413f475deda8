#version 450 core
// One thread a triangle: a bit for each view in which it may be seen, and how many there are in a block of them.
layout(local_size_x = 256) in;
#include "common/frame.glsl"
#include "common/body.glsl"
#include "common/cull.glsl"
layout(std430, binding = 2) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 3) writeonly buffer SeenBits { uint seen_bits[]; };
layout(std430, binding = 4) writeonly buffer BlockCounts { uint block_counts[]; };
layout(std430, binding = 5) readonly buffer Vertices { uint vertex_words[]; };  // 6 words a vertex
layout(std430, binding = 6) readonly buffer Commands { DrawCommand commands[]; };
layout(location = 2) uniform float rounding;  // px, of window positions by the rasteriser
layout(location = 3) uniform int sample_count;
layout(location = 4) uniform vec2 sample_position[4];  // inside the pixel, 0..1
layout(location = 8) uniform float shadow_texels;      // along a region

// Rounding of single precision through rest position, motion and projection, of the terms' size.
const float kArithmetic = 1e-6;

struct Window {
    vec2 p[3];    // px
    float slack;  // px: by how much the rasteriser's may differ
    vec2 size;    // px
};

float sizeOf(vec3 v) { return abs(v.x) + abs(v.y) + abs(v.z); }

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }
float reach(vec2 v) { return abs(v.x) + abs(v.y); }

bool isSurelyBackFacing(Window w) {
    vec2 a = w.p[1] - w.p[0], b = w.p[2] - w.p[0];
    return cross2(a, b) < -2.0 * w.slack * (reach(a) + reach(b)) - 8.0 * w.slack * w.slack;
}

// Is a point outside of one of the edges, however they are rounded?
bool isSurelyOutside(Window w, vec2 at) {
    for (int k = 0; k < 3; ++k) {
        vec2 edge = w.p[(k + 1) % 3] - w.p[k], to = at - w.p[k];
        float doubt = w.slack * (2.0 * reach(to) + reach(edge)) + 4.0 * w.slack * w.slack;
        if (cross2(edge, to) < -doubt) return true;
    }
    return false;
}

// Looks at every sample in the box of a small triangle; larger ones have one almost surely.
bool mayCover(Window w, int samples) {
    vec2 low = min(w.p[0], min(w.p[1], w.p[2])) - w.slack, high = max(w.p[0], max(w.p[1], w.p[2])) + w.slack;
    low = max(low, vec2(0.0));
    high = min(high, w.size);
    if (any(greaterThan(low, high))) return false;
    const float kSmall = 3.0;  // px
    if (any(greaterThan(high - low, vec2(kSmall)))) return true;
    for (int i = 0; i < samples; ++i) {
        vec2 inside = samples > 1 ? sample_position[i] : vec2(0.5);
        vec2 first = ceil(low - inside), last = floor(high - inside);
        for (float y = first.y; y <= last.y; y += 1.0) {
            for (float x = first.x; x <= last.x; x += 1.0) {
                if (!isSurelyOutside(w, vec2(x, y) + inside)) return true;
            }
        }
    }
    return false;
}

bool mayBeSeen(vec3 p[3], float size) {
    vec2 picture = frame.viewport.xy;
    float near = frame.depth_range.x, least_w = 1e30, most_w = -1e30;
    Window w;
    w.size = picture;
    for (int k = 0; k < 3; ++k) {
        vec4 clip = frame.view_projection * vec4(p[k], 1.0);
        least_w = min(least_w, clip.w);
        most_w = max(most_w, clip.w);
        w.p[k] = (clip.xy / clip.w * 0.5 + 0.5) * picture;
    }
    float arithmetic = kArithmetic * (size + sizeOf(frame.eye.xyz));  // m
    if (most_w < near - arithmetic) return false;
    if (least_w < near + arithmetic) return true;  // the near plane cuts it
    float pixels_per_metre = picture.y / (2.0 * frame.depth_range.z * least_w);
    w.slack = rounding + arithmetic * pixels_per_metre + kArithmetic * (picture.x + picture.y);
    return !isSurelyBackFacing(w) && mayCover(w, sample_count);
}

bool mayCastShadow(vec3 p[3], float size, int region) {
    Window w;
    w.size = vec2(shadow_texels);
    for (int k = 0; k < 3; ++k) w.p[k] = (frame.light_matrix[region] * vec4(p[k], 1.0)).xy * shadow_texels;
    float arithmetic = kArithmetic * (size + sizeOf(frame.scene.xyz) + sizeOf(frame.eye.xyz));
    w.slack = rounding + arithmetic / frame.shadow[region].x + kArithmetic * shadow_texels;
    return !isSurelyBackFacing(w) && mayCover(w, 1);
}

shared uint words[kViews * kWordsPerBlock];

uint viewsOf(uint triangle) {
    vec3 p[3];
    float size = 0.0;
    for (uint k = 0u; k < 3u; ++k) {
        uint word = 6u * indices[3u * triangle + k];
        vec3 rest = uintBitsToFloat(uvec3(vertex_words[word], vertex_words[word + 1u], vertex_words[word + 2u]));
        p[k] = moved(transforms[particle_fragment[vertex_words[word + 5u]]], rest);
        size = max(size, sizeOf(p[k]) + sizeOf(rest));
    }
    return uint(mayBeSeen(p, size)) | uint(mayCastShadow(p, size, 0)) << 1 | uint(mayCastShadow(p, size, 1)) << 2;
}

void main() {
    uint thread = gl_LocalInvocationIndex, triangles = commands[source_command].count / 3u;
    uint blocks = (triangles + kTrianglesPerBlock - 1u) / kTrianglesPerBlock;
    for (uint block = gl_WorkGroupID.x; block < blocks; block += gl_NumWorkGroups.x) {
        if (thread < kViews * kWordsPerBlock) words[thread] = 0u;
        barrier();
        uint triangle = block * kTrianglesPerBlock + thread;
        uint views = triangle < triangles ? viewsOf(triangle) : 0u;
        for (uint view = 0u; view < kViews; ++view) {
            if ((views >> view & 1u) != 0u) atomicOr(words[view * kWordsPerBlock + thread / 32u], 1u << (thread & 31u));
        }
        barrier();
        uint view = thread / kWordsPerBlock, first = view * kWordsPerBlock;
        if (view < kViews) {
            seen_bits[(view * block_room + block) * kWordsPerBlock + thread - first] = words[thread];
            uint sum = 0u;
            for (uint k = 0u; k < kWordsPerBlock; ++k) sum += uint(bitCount(words[first + k]));
            if (thread == first) block_counts[view * block_room + block] = sum;
        }
        barrier();
    }
}
