// SPDX-License-Identifier: Apache-2.0
// Meshes of a glTF file as its viewers show them before anything moves: with the weights that their morph
// targets have, and where the joints of their skins stand. assimp leaves both to its users.
#pragma once

struct aiScene;

namespace demolish {

/// Moves vertices and normals, so that nodes then place them as all others.
void poseAtRest(aiScene& scene);

}  // namespace demolish
