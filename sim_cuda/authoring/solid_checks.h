// SPDX-License-Identifier: Apache-2.0
// What a triangle mesh has to be for a body, and where the body stands.
#pragma once
#include <filesystem>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

/// Throws InputFileError, naming `file`, when an edge is open or the volume is zero, negative or beyond all
/// numbers.
void requireSolid(const TriangleMesh& mesh, const std::filesystem::path& file);

/// Lowest y = 0, centred in x and z, scaled to placement.height (m) unless keep_units. Throws UsageError for
/// a height that is not positive, InputFileError where the scaled mesh is beyond what numbers hold.
void standOnFloor(TriangleMesh& mesh, const std::filesystem::path& file, const MeshPlacement& placement);

}  // namespace demolish
