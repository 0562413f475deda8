#version 450 core
// Large tiles in two tones with thin joints.
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/noise.glsl"
in vec3 world_position;
layout(location = 0) out vec4 material_out;
layout(location = 1) out vec4 normals_out;
layout(location = 0) uniform float tile_size;  // m

// Mean of a square wave (+1, -1, period 2) over a pixel of width w: edges stay smooth, far tiles melt to the mean.
float filteredWave(float x, float w) {
    vec2 ends = vec2(x - 0.5 * w, x + 0.5 * w);
    vec2 integral = abs(fract(ends * 0.5) * 2.0 - 1.0);
    return clamp((integral.x - integral.y) / w, -1.0, 1.0);
}

// Coverage of a joint of half width h at whole numbers, seen through a pixel of width w.
float joint(float x, float h, float w) {
    float distance = abs(fract(x + 0.5) - 0.5);
    float blur = max(w, 1e-4);
    return clamp((h + 0.5 * blur - distance) / blur, 0.0, 1.0) * min(1.0, 2.0 * h / blur);
}

void main() {
    vec2 tile = world_position.xz / tile_size;
    vec2 width = max(fwidth(tile), vec2(1e-4));
    float checker = filteredWave(tile.x, width.x) * filteredWave(tile.y, width.y);
    float line = max(joint(tile.x, 0.006, width.x), joint(tile.y, 0.006, width.y));
    float cloud = noise(vec3(world_position.xz / (0.7 * tile_size), 0.3)).w;
    float grain = noise(vec3(world_position.xz / (0.045 * tile_size), 1.7)).w;

    Surface s;
    s.position = world_position;
    s.geometric_normal = vec3(0.0, 1.0, 0.0);
    s.normal = s.geometric_normal;
    s.albedo = frame.floor_colour.rgb * (1.0 + 0.055 * checker + 0.02 * cloud + 0.02 * grain) * (1.0 - 0.28 * line);
    s.roughness = clamp(0.62 + 0.1 * cloud, 0.05, 1.0);
    s.metalness = 0.0;
    material_out = packMaterial(s);
    normals_out = packNormals(s);
}
