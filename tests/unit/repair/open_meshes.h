// SPDX-License-Identifier: Apache-2.0
// Small meshes with one fault each.
#pragma once
#include <set>

#include "sim_cuda/authoring/repair/repair_mesh.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {

/// Corners with the normals of the faces and no texture coordinates.
TriangleMesh meshOf(std::vector<Double3> positions, std::vector<Triangle> triangles);

/// `columns` x `rows` squares of side `step` (m) in the plane y = 0, facing up, from the origin on.
TriangleMesh makeSheet(int columns, int rows, double step);

/// Lateral surface of a cylinder about the y axis, `sides` flat sides, outside out.
TriangleMesh makeOpenTube(double radius, double height, int sides);

/// A box of the given sides (m) about a point.
TriangleMesh makeBox(const Double3& middle, const Double3& sides);

/// Without the triangles of these numbers.
TriangleMesh without(TriangleMesh mesh, const std::set<size_t>& triangles);

/// Every triangle with vertices of its own.
TriangleMesh unwelded(const TriangleMesh& mesh);

}  // namespace demolish::test
