// SPDX-License-Identifier: Apache-2.0
// Broken faces near the camera, made finer with the material's relief in them (relief_faces.comp): they are shown in place of
// the mesh's own broken faces of the cells that are marked. Counts of 0: none are.
layout(std430, binding = 16) readonly buffer NearCells { uint near_cells[]; };  // 1: replaced
layout(std430, binding = 17) readonly buffer NearIndices {
    uint near_command[5];   // as common/commands.glsl; the first index is the one after these words
    uint near_groups[3];
    uint near_indices[];    // 3 a triangle, into near_words
};
layout(std430, binding = 18) readonly buffer NearVertices { uvec2 near_words[]; };  // 3 pairs a vertex, as of broken faces

uint nearTriangles() { return near_command[0] / 3u; }

bool isReplaced(uint cell) { return near_command[0] > 0u && near_cells[cell] != 0u; }
