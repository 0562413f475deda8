// SPDX-License-Identifier: Apache-2.0
// What a triangle mesh has to be for a body, and where the body stands.
#pragma once
#include <filesystem>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

/// No edge is open, no triangle is there twice, and the volume is positive and more than rounding.
bool isSolid(const TriangleMesh& mesh);

/// Throws InputFileError, naming `file`, when an edge is open or the volume is zero, negative or beyond all
/// numbers.
void requireSolid(const TriangleMesh& mesh, const std::filesystem::path& file);

/// A quarter turn about x: z becomes y, y becomes -z.
void turnZUp(TriangleMesh& mesh);

/// m, of the longest side. What is smaller has masses and moments beyond single precision; what is larger
/// becomes unstable, seen from 12 km on.
inline constexpr double kShortestBody = 1e-6, kLongestBody = 1e4;

/// Scaled, with the lowest y = 0, centred in x and z. Throws InputFileError where the scaled mesh is larger
/// or smaller than a body can be.
void standOnFloor(TriangleMesh& mesh, const std::filesystem::path& file, double scale);

}  // namespace demolish
