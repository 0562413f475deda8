// SPDX-License-Identifier: Apache-2.0
// Trowelled concrete: clouds of all sizes, fine pores, cut into wide slabs.
const float kSlab = 6.0;  // edges of a checker's tile

void floorMaterial(FloorPlace place, inout Surface s) {
    float tile_size = frame.eye.w;
    vec2 slab = place.at / (kSlab * tile_size) + 0.37,
         width = max(place.width / (kSlab * tile_size), vec2(1e-5));
    float cut = max(joint(slab.x, 0.0008, width.x), joint(slab.y, 0.0008, width.y));
    float wide = floorNoise(place, 2.3 * tile_size, 0.3), cloud = floorNoise(place, 0.55 * tile_size, 2.1);
    float trowel =
        noiseOver(vec3(place.at / (tile_size * vec2(0.9, 0.16)), 4.4), place.footprint / (0.16 * tile_size))
            .w;
    float tone = 1.0 + 0.2 * wide + 0.2 * cloud + 0.1 * trowel;
    if (kFineGrain) {
        float grain = floorNoise(place, 0.02 * tile_size, 1.7),
              pores = floorNoise(place, 0.05 * tile_size, 3.3);
        tone *= (1.0 + 0.10 * grain) * (1.0 - 0.35 * smoothstep(0.45, 0.75, pores));
    }
    s.albedo = frame.floor_colour.rgb * vec3(1.02, 1.0, 0.97) * tone * (1.0 - 0.45 * cut);
    s.roughness = clamp(0.75 + 0.16 * cloud + 0.08 * wide, 0.05, 1.0);
}
