// SPDX-License-Identifier: Apache-2.0
#version 450 core
// One square over each listed tile (touched_tiles.comp).
layout(std430, binding = 6) readonly buffer TouchedTiles {
    uint vertices_per_tile, tile_count, first_vertex, first_tile;
    uint tiles[];
};
layout(location = 31) uniform vec3 tile;  // width and height of one, of the whole picture 1; depth

void main() {
    uint place = tiles[gl_InstanceID];
    vec2 corner = vec2(place & 0xffffu, place >> 16) + vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(2.0 * corner * tile.xy - 1.0, tile.z, 1.0);
}
