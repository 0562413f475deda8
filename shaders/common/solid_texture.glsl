// SPDX-License-Identifier: Apache-2.0
// What a solid is made of at a place: a function of the rest position alone, so that what runs over the outside goes on in
// the break, on both sides of it. TEXTURE: engine::SolidTexture. `texture_shape`: x 1/m of the pattern, y its share on the
// outside, z thickness of a coat, m.
#define TEXTURE_NONE 0
#define TEXTURE_VEINS 1
#define TEXTURE_LAYERS 2
#define TEXTURE_CRYSTALS 3
#define TEXTURE_PEBBLES 4
#define TEXTURE_BRICKS 5
#define TEXTURE_GRAINS 6
#ifndef TEXTURE
#define TEXTURE TEXTURE_NONE
#endif

struct Solid {
    float other;   // share of the second colour, 0..1
    float tone;    // factor of either colour, about 1
    float skin;    // factor of the colour of an outside that hides the solid, about 1
    float smoothed;  // share by which the roughness of a broken face is taken off, 0..1
};

#if TEXTURE >= TEXTURE_CRYSTALS
layout(binding = 13) uniform sampler3D cell_volume;  // engine/render/cell_volume.h
const float kCellPeriod = 8.0, kCellTexels = 8.0;

// `p` in m, `per_metre` lattice cells.
vec4 cells(vec3 p, float per_metre) {
#ifdef COMPUTED
    float wide = noise_footprint * per_metre * kCellTexels;
    return textureLod(cell_volume, p * per_metre / kCellPeriod, log2(max(wide, 1e-6)));
#else
    return texture(cell_volume, p * per_metre / kCellPeriod);
#endif
}

// Moved slowly by up to a cell and more, or the eye would find the period.
vec3 unrepeated(vec3 rest) { return rest + 0.8 / texture_shape.x * noise(rest, 0.09 * texture_shape.x).xyz; }
#endif

// Width of a pixel on the surface, m.
float pixelAt(vec3 rest) {
#ifdef COMPUTED
    return noise_footprint;
#else
    return 0.7 * length(fwidth(rest));
#endif
}

#if TEXTURE == TEXTURE_VEINS
// Sheets where noise is zero, as wide everywhere as `wide` says (of a lattice cell) for its steepness.
float sheet(vec4 n, float wide, float pixel) {
    float away = abs(n.w) / max(length(n.xyz), 0.35), blur = max(wide, 0.6 * pixel);
    return (1.0 - smoothstep(0.0, blur, away)) * min(1.0, wide / blur);
}

// Along and across the sheets of a rock that was pressed and sheared.
const mat3 kBedding = mat3(0.80, -0.48, 0.36, 0.60, 0.64, -0.48, 0.0, 0.60, 0.80);

Solid solidAt(vec3 rest) {
    float scale = texture_shape.x, pixel = pixelAt(rest) * scale;
    vec4 fold = noise(kTurn1 * rest, 0.25 * scale), bend = noise(kTurn2 * rest, 0.7 * scale), shiver = noise(kTurn1 * rest, 2.9 * scale);
    vec3 p = kBedding * (rest + (0.5 * fold.xyz + 0.15 * bend.xyz + 0.03 * shiver.xyz) / scale);
    // Sheets of three sizes, much longer along the bedding than across: few wide ones, a net of fine ones.
    vec4 broad = noise(p * vec3(1.0, 0.16, 0.22), 0.9 * scale), fine = noise(kTurn1 * p * vec3(1.0, 0.25, 0.2), 1.9 * scale);
    vec4 hair = noise(kTurn2 * p * vec3(1.0, 0.25, 0.25), 4.1 * scale);
    // Veins gather where the rock is grey, pinch out, and leave other parts white.
    float grey = smoothstep(-0.5, 0.5, fold.w + 0.5 * bend.w), here = smoothstep(-0.45, 0.35, bend.w - 0.4 * fold.w + 0.4 * fine.w);
    Solid s;
    s.other = (0.28 + 0.42 * grey) * here * sheet(broad, 0.02 + 0.07 * grey, 0.9 * pixel);
    s.other = max(s.other, (0.12 + 0.40 * grey) * here * sheet(fine, 0.06, 1.9 * pixel));
    s.other = max(s.other, 0.26 * grey * sheet(hair, 0.10, 4.1 * pixel));
    s.other += (0.02 + 0.24 * grey) * (1.0 - smoothstep(0.0, 0.55, abs(broad.w + 0.25 * shiver.w)));
    s.other += 0.12 * grey * smoothstep(-0.4, 0.6, hair.w + fine.w);
    s.tone = 1.0 + 0.04 * fold.w + 0.03 * hair.w;
    s.skin = 1.0;
    s.smoothed = 0.3;
    return s;
}
#elif TEXTURE == TEXTURE_LAYERS
Solid solidAt(vec3 rest) {
    float scale = texture_shape.x;
    float height = rest.y * scale + 0.22 * noise(rest, 0.35 * scale).w + 0.05 * noise(rest, 1.3 * scale).w;
    float broad = noise(vec3(3.7, height, 1.3), 1.0).w, thin = noise(vec3(0.4, 3.1 * height, 6.2), 1.0).w;
    vec4 sand = noise(rest, 24.0 * scale);
    Solid s;
    s.other = smoothstep(-0.5, 0.6, broad + 0.5 * thin);
    s.tone = 1.0 + 0.10 * thin + 0.10 * sand.w;
    s.skin = 1.0;
    s.smoothed = 0.0;
    return s;
}
#elif TEXTURE == TEXTURE_CRYSTALS
Solid solidAt(vec3 rest) {
    float scale = texture_shape.x;
    vec4 cloud = noise(kTurn2 * rest, 0.13 * scale);
    vec3 p = unrepeated(rest);
    vec4 coarse = cells(kTurn1 * p, scale), fine = cells(kTurn2 * p, 2.3 * scale);
    // Dark mica in small flakes that gather in clouds, feldspar in large crystals, quartz between. From where they are smaller
    // than a pixel their steps widen until what is left is their share, or single ones would be dots of a pixel.
    float pixel = pixelAt(rest) * scale, blur = min(1.15 * pixel, 0.8), broad = min(0.5 * pixel, 0.6);
    float flake = smoothstep(-blur, 0.08 + blur, fine.a - 0.74 + 0.14 * cloud.w), edge = 1.0 - smoothstep(0.0, 0.10, coarse.b);
    Solid s;
    s.other = max(flake, 0.8 * smoothstep(0.90 - broad, 0.93 + broad, coarse.a));
    s.tone = 0.66 + 0.62 * coarse.a + 0.16 * (fine.a - 0.5) - 0.10 * edge + 0.06 * cloud.w;
    s.skin = 1.0;
    s.smoothed = 0.35 * coarse.a;
    return s;
}
#elif TEXTURE == TEXTURE_PEBBLES
Solid solidAt(vec3 rest) {
    float scale = texture_shape.x, blur = 0.015 + 0.5 * pixelAt(rest) * scale;
    vec3 p = unrepeated(rest);
    vec4 large = cells(kTurn1 * p, scale), small = cells(kTurn2 * p, 2.9 * scale), sand = cells(p, 9.0 * scale);
    float in_large = 1.0 - smoothstep(-blur, blur, large.r - 0.5);
    float in_small = 1.0 - smoothstep(-2.9 * blur, 2.9 * blur, small.r - 0.5);
    float stone = max(in_large, in_small), tone = mix(small.g, large.g, in_large);
    // The paste is darker where it clings to a stone, and holds sand.
    float cling = (1.0 - stone) * (1.0 - smoothstep(0.0, 0.12, large.r - 0.5));
    Solid s;
    s.other = stone;
    s.tone = mix(0.93 + 0.18 * (sand.a - 0.4) - 0.14 * cling, 0.62 + 0.62 * tone, stone);
    // What a mould leaves: stains, and pores where air was caught.
    vec4 stain = noise(kTurn1 * rest, 0.35 * scale), spot = noise(rest, 1.1 * scale);
    vec4 air = cells(kTurn1 * rest, 4.3 * scale);
    float pore = (1.0 - smoothstep(-4.3 * blur, 4.3 * blur, air.r - 0.22)) * step(0.72, air.g);
    s.skin = (1.0 + 0.10 * stain.w + 0.07 * spot.w + 0.10 * (sand.a - 0.5)) * (1.0 - 0.5 * pore);
    s.smoothed = 0.75 * stone;
    return s;
}
#elif TEXTURE == TEXTURE_BRICKS
// A wall of stretchers, a header deep: length, height and depth of a brick with its joint, of the size given.
const vec3 kBrick = vec3(1.0, 0.3125, 0.5);
const float kJoint = 0.045;
const vec3 kFirstBrick = vec3(0.31, 0.02, 0.27);  // so that no side of a body is all joint

float draw(vec3 n) { return fract(sin(dot(n, vec3(12.9898, 78.233, 37.719))) * 43758.5453); }

Solid solidAt(vec3 rest) {
    float scale = texture_shape.x, pixel = pixelAt(rest) * scale;
    vec3 p = rest * scale + kFirstBrick + 0.012 * noise(rest, 3.0 * scale).xyz;
    float course = floor(p.y / kBrick.y);
    p.x += 0.5 * mod(course, 2.0);
    vec3 place = p / kBrick, brick = floor(place), in_brick = abs(fract(place) - 0.5) * kBrick;
    vec3 to_edge = 0.5 * kBrick - in_brick;
    float away = min(to_edge.x, min(to_edge.y, to_edge.z)) - 0.5 * kJoint;
    float blur = max(0.006, 0.6 * pixel);
    vec4 clay = noise(rest, 5.0 * scale), grit = cells(kTurn1 * rest, 60.0 * scale);
    Solid s;
    s.other = 1.0 - smoothstep(-blur, blur, away);
    float fired = 0.78 + 0.42 * draw(brick), speck = smoothstep(0.78, 0.9, grit.a);
    s.tone = mix(fired * (1.0 + 0.10 * clay.w) * (1.0 - 0.25 * speck), 0.95 + 0.10 * (grit.a - 0.5), s.other);
    s.skin = 1.0;
    s.smoothed = 0.0;
    return s;
}
#elif TEXTURE == TEXTURE_GRAINS
// Fine stuff with a few coarse grains and pores in it.
Solid solidAt(vec3 rest) {
    float scale = texture_shape.x, blur = 0.03 + 0.5 * pixelAt(rest) * scale;
    vec3 p = unrepeated(rest);
    vec4 grog = cells(kTurn1 * p, scale), fine = cells(kTurn2 * p, 3.3 * scale), cloud = noise(rest, 0.12 * scale);
    float grain = (1.0 - smoothstep(-blur, blur, grog.r - 0.36)) * step(0.3, grog.g);
    float pore = smoothstep(0.90, 0.96, fine.a);
    Solid s;
    s.other = grain;
    s.tone = (1.0 + 0.07 * cloud.w + 0.10 * (fine.a - 0.5)) * (1.0 - 0.35 * pore * (1.0 - grain));
    s.skin = 1.0;
    s.smoothed = 0.0;
    return s;
}
#endif
