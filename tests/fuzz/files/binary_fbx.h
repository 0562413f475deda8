// SPDX-License-Identifier: Apache-2.0
// A small binary FBX file (version 7.4): assimp's own exporter writes some that assimp does not read.
#pragma once
#include <string>

#include "sim_cuda/api/triangle_mesh.h"

namespace demolish::fuzz {

/// One mesh under one model, as https://code.blender.org/2013/08/fbx-binary-file-format-specification says.
std::string binaryFbx(const TriangleMesh& mesh);

}  // namespace demolish::fuzz
