// SPDX-License-Identifier: Apache-2.0
#version 450 core
// One square over each listed tile, at the depth of emptiness.
layout(std430, binding = 6) readonly buffer TouchedTiles {
    uint vertices_per_tile, tile_count, first_vertex, first_tile;
    uint tiles[];
};
layout(location = 0) uniform vec4 tile_empty;  // xy: width and height of a tile, of the whole picture 1; z: empty depth

void main() {
    uint tile = tiles[gl_InstanceID];
    vec2 corner = vec2(tile & 0xffffu, tile >> 16) + vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(2.0 * corner * tile_empty.xy - 1.0, tile_empty.z, 1.0);
}
