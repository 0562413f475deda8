// SPDX-License-Identifier: Apache-2.0
// Oak boards along z, each of its own tone, with grain, laid with staggered ends.
const float kBoardsPerTile = 4.0, kBoardLength = 9.0;  // in widths of a board

void floorMaterial(FloorPlace place, inout Surface s) {
    float board_width = frame.eye.w / kBoardsPerTile;
    vec2 at = place.at / board_width, width = max(place.width / board_width, vec2(1e-4));
    float row = floor(at.x);
    float along = at.y / kBoardLength + 7.0 * ownValue(vec2(row, 1.0));
    float value = ownValue(vec2(row, floor(along) + 17.0));
    float melted = smoothstep(0.5, 2.0, width.x);  // far boards melt to their mean
    float gap = max(joint(at.x, 0.012, width.x), joint(along, 0.012 / kBoardLength, width.y / kBoardLength));
    vec3 grain_at = vec3(9.0 * at.x, 0.35 * at.y, 13.0 * value);
    float ring =
        noiseOver(vec3(2.2 * at.x, 0.16 * at.y, 29.0 * value), 2.2 * place.footprint / board_width).w;
    float grain = noiseOver(grain_at, 9.0 * place.footprint / board_width).w;
    float fibre =
        kFineGrain ? noiseOver(grain_at * vec3(4.0, 2.0, 1.0), 36.0 * place.footprint / board_width).w : 0.0;
    float tone = 1.0 + mix(0.55 * (value - 0.5), 0.0, melted) + 0.22 * ring + 0.16 * grain + 0.10 * fibre;
    vec3 wood = mix(vec3(0.215, 0.125, 0.068), vec3(0.30, 0.185, 0.105), mix(value, 0.5, melted));
    s.albedo = wood * tone * (1.0 - 0.75 * gap);
    s.roughness = clamp(0.42 + 0.12 * ring + 0.06 * grain, 0.05, 1.0);
}
