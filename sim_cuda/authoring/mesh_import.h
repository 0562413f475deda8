// SPDX-License-Identifier: Apache-2.0
// Model file in, checked triangle mesh out.
#pragma once
#include <filesystem>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/authoring/triangle_mesh.h"

namespace demolish {

/// Reads every triangle of the file's scene (node transforms applied, in metres where the format says its
/// unit), welds vertices of equal position and drops triangles that lost a corner by it. Not checked yet
/// whether it is closed. Throws InputFileError: unreadable, no triangles, vertices that are not finite.
TriangleMesh importTriangles(const std::filesystem::path& file);

/// Throws InputFileError, naming `file`, when an edge is open or the volume is zero or negative.
void requireSolid(const TriangleMesh& mesh, const std::filesystem::path& file);

/// Lowest y = 0, centred in x and z, scaled to placement.height (m) unless keep_units. Throws UsageError for
/// a height that is not positive.
void standOnFloor(TriangleMesh& mesh, const MeshPlacement& placement);

}  // namespace demolish
