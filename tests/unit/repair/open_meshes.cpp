// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/repair/open_meshes.h"

#include <cmath>
#include <numbers>

#include "sim_cuda/authoring/double3.h"

namespace demolish::test {

TriangleMesh meshOf(std::vector<Double3> positions, std::vector<Triangle> triangles) {
    TriangleMesh mesh;
    mesh.positions = std::move(positions);
    mesh.triangles = std::move(triangles);
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        mesh.corners.push_back(flatCorners(normalized(cross(p[b] - p[a], p[c] - p[a]))));
    }
    return mesh;
}

TriangleMesh makeSheet(int columns, int rows, double step) {
    std::vector<Double3> positions;
    std::vector<Triangle> triangles;
    for (int z = 0; z <= rows; ++z)
        for (int x = 0; x <= columns; ++x) positions.push_back({x * step, 0, z * step});
    const auto id = [&](int x, int z) { return uint32_t(z * (columns + 1) + x); };
    for (int z = 0; z < rows; ++z)
        for (int x = 0; x < columns; ++x) {
            triangles.push_back({id(x, z), id(x, z + 1), id(x + 1, z + 1)});
            triangles.push_back({id(x, z), id(x + 1, z + 1), id(x + 1, z)});
        }
    return meshOf(std::move(positions), std::move(triangles));
}

TriangleMesh makeOpenTube(double radius, double height, int sides) {
    std::vector<Double3> positions;
    std::vector<Triangle> triangles;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        for (const double y : {0.0, height})
            positions.push_back({radius * std::cos(angle), y, radius * std::sin(angle)});
    }
    for (int i = 0; i < sides; ++i) {
        const auto a = uint32_t(2 * i), b = uint32_t(2 * ((i + 1) % sides));
        triangles.push_back({a, a + 1, b + 1});
        triangles.push_back({a, b + 1, b});
    }
    return meshOf(std::move(positions), std::move(triangles));
}

TriangleMesh makeBox(const Double3& middle, const Double3& sides) {
    TriangleMesh box = makeCube(1);
    for (Double3& p : box.positions) p = middle + Double3{p.x * sides.x, p.y * sides.y, p.z * sides.z};
    return box;
}

TriangleMesh without(TriangleMesh mesh, const std::set<size_t>& triangles) {
    RepairMesh repair(std::move(mesh));
    std::vector<char> flags(repair.size(), 1);
    for (const size_t t : triangles) flags[t] = 0;
    repair.keep(flags);
    return repair.mesh;
}

TriangleMesh unwelded(const TriangleMesh& mesh) {
    TriangleMesh loose = mesh;
    loose.positions.clear();
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            loose.triangles[t][k] = uint32_t(loose.positions.size());
            loose.positions.push_back(mesh.positions[mesh.triangles[t][k]]);
        }
    return loose;
}

}  // namespace demolish::test
