// SPDX-License-Identifier: Apache-2.0
// A drawing board: plain, with a fine line each fifth of a tile and a strong one at each tile.
void floorMaterial(FloorPlace place, inout Surface s) {
    vec2 tile = place.at / frame.eye.w, width = max(place.width / frame.eye.w, vec2(1e-4));
    float strong = max(joint(tile.x, 0.006, width.x), joint(tile.y, 0.006, width.y));
    float fine = max(joint(5.0 * tile.x, 0.012, 5.0 * width.x), joint(5.0 * tile.y, 0.012, 5.0 * width.y));
    s.albedo = frame.floor_colour.rgb * (1.0 + 0.9 * strong + 0.3 * fine);
    s.roughness = 0.8;
}
