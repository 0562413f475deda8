// SPDX-License-Identifier: Apache-2.0
// A mesh on its way through the repair, with what each triangle comes from and belongs to.
#pragma once
#include <vector>

#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

using Triangle = std::array<uint32_t, 3>;
using Corners = std::array<CornerAttributes, 3>;

inline constexpr uint32_t kNoSource = 0xffffffffu;  ///< of a triangle that the repair made

struct RepairMesh {
    RepairMesh() = default;
    /// Every triangle is its own source; one patch, one part.
    explicit RepairMesh(TriangleMesh file_mesh);

    TriangleMesh mesh;
    std::vector<uint32_t> source;  ///< number of the file's triangle, by triangle
    std::vector<uint32_t> patch;   ///< by triangle: joined through edges of exactly two faces
    std::vector<uint32_t> part;    ///< by triangle: joined through any edge
    uint32_t patches = 1, parts = 1;

    size_t size() const { return mesh.triangles.size(); }
    const Double3& at(size_t triangle, int corner) const {
        return mesh.positions[mesh.triangles[triangle][size_t(corner)]];
    }
    Double3 middle(size_t triangle) const;
    /// m^2
    double area(size_t triangle) const;
    /// Unit; zero where there is no area.
    Double3 normal(size_t triangle) const;

    /// The other side out, normals of the corners as well.
    void turn(size_t triangle);
    void add(const Triangle& vertices, const Corners& corners, uint32_t of_source, uint32_t of_patch,
             uint32_t of_part);
    /// A triangle of the repair's own, with the normal of its plane and no texture coordinates.
    void addOwn(const Triangle& vertices, uint32_t of_patch, uint32_t of_part);
    /// Drops triangles whose flag is 0; vertices stay.
    void keep(const std::vector<char>& flags);
};

/// Length of the box about the vertices, m; 0 without vertices.
double diagonalOf(const TriangleMesh& mesh);
/// Corners with their sides changed.
Corners turned(const Corners& corners);
/// Corners that all have this normal.
Corners flatCorners(const Double3& unit_normal);

}  // namespace demolish
