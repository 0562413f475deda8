// SPDX-License-Identifier: Apache-2.0
// Edits that keep all arrays of the mesh in step.
#include "sim_cuda/authoring/repair/repair_mesh.h"

#include <numeric>

#include "sim_cuda/authoring/bounds.h"

namespace demolish {
namespace {

template <typename Value>
void keepFlagged(std::vector<Value>& values, const std::vector<char>& flags) {
    size_t kept = 0;
    for (size_t i = 0; i < values.size(); ++i)
        if (flags[i] != 0) values[kept++] = values[i];
    values.resize(kept);
}

}  // namespace

RepairMesh::RepairMesh(TriangleMesh file_mesh)
    : mesh(std::move(file_mesh)), source(size()), patch(size(), 0), part(size(), 0) {
    std::iota(source.begin(), source.end(), 0u);
}

Double3 RepairMesh::middle(size_t triangle) const {
    return (at(triangle, 0) + at(triangle, 1) + at(triangle, 2)) * (1.0 / 3);
}

double RepairMesh::area(size_t triangle) const {
    return length(cross(at(triangle, 1) - at(triangle, 0), at(triangle, 2) - at(triangle, 0))) / 2;
}

Double3 RepairMesh::normal(size_t triangle) const {
    return normalized(cross(at(triangle, 1) - at(triangle, 0), at(triangle, 2) - at(triangle, 0)));
}

Corners turned(const Corners& corners) {
    Corners other{corners[0], corners[2], corners[1]};
    for (CornerAttributes& corner : other)
        corner.normal = {-corner.normal.x, -corner.normal.y, -corner.normal.z};
    return other;
}

Corners flatCorners(const Double3& unit_normal) {
    const Float3 normal{float(unit_normal.x), float(unit_normal.y), float(unit_normal.z)};
    return {{{normal, {}}, {normal, {}}, {normal, {}}}};
}

void RepairMesh::turn(size_t triangle) {
    std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
    mesh.corners[triangle] = turned(mesh.corners[triangle]);
}

void RepairMesh::add(const Triangle& vertices, const Corners& corners, uint32_t of_source, uint32_t of_patch,
                     uint32_t of_part) {
    mesh.triangles.push_back(vertices);
    mesh.corners.push_back(corners);
    source.push_back(of_source);
    patch.push_back(of_patch);
    part.push_back(of_part);
}

void RepairMesh::addOwn(const Triangle& vertices, uint32_t of_patch, uint32_t of_part) {
    const auto& p = mesh.positions;
    const Double3 normal =
        normalized(cross(p[vertices[1]] - p[vertices[0]], p[vertices[2]] - p[vertices[0]]));
    add(vertices, flatCorners(normal), kNoSource, of_patch, of_part);
}

void RepairMesh::keep(const std::vector<char>& flags) {
    keepFlagged(mesh.triangles, flags);
    keepFlagged(mesh.corners, flags);
    keepFlagged(source, flags);
    keepFlagged(patch, flags);
    keepFlagged(part, flags);
}

double diagonalOf(const TriangleMesh& mesh) {
    return mesh.positions.empty() ? 0 : length(boundsOf(mesh.positions).size());
}

}  // namespace demolish
