// SPDX-License-Identifier: Apache-2.0
// Large tiles of stone in two tones, each a little lighter or darker than the next, with thin joints.
#include "common/stone.glsl"

void floorMaterial(FloorPlace place, inout Surface s) {
    float tile_size = frame.eye.w;
    vec2 tile = place.at / tile_size, width = max(place.width / tile_size, vec2(1e-4));
    float checker = filteredWave(tile.x, width.x) * filteredWave(tile.y, width.y);
    float distinct = 1.0 - smoothstep(0.1, 0.5, max(width.x, width.y));  // far tiles melt to their mean
    float own = distinct * (ownValue(floor(tile)) - 0.5);
    float line = max(joint(tile.x, 0.006, width.x), joint(tile.y, 0.006, width.y));
    float cloud = floorNoise(place, 0.7 * tile_size, 0.3);
    float grain = kFineGrain ? floorNoise(place, 0.045 * tile_size, 1.7) : 0.0;
    float tone = 1.0 + 0.07 * checker + 0.16 * own + 0.05 * cloud + 0.03 * grain;
    s.albedo = frame.floor_colour.rgb * tone * (1.0 - 0.4 * line);
    s.roughness = stoneRoughness(cloud);
}
