// SPDX-License-Identifier: Apache-2.0
// Counts open edges and doubled triangles, sums volume and area.
#include "sim_cuda/authoring/mesh_checks.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/double3.h"

namespace demolish {

size_t openEdgeCount(const TriangleMesh& mesh) {
    std::vector<uint64_t> uses;  // lower id, higher id, direction in the last bit
    uses.reserve(mesh.triangles.size() * 3);
    for (const auto& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
            uses.push_back(uint64_t(low) << 33 | uint64_t(high) << 1 | uint64_t(t[k] > t[(k + 1) % 3]));
        }
    }
    tbb::parallel_sort(uses.begin(), uses.end());
    size_t open = 0;
    for (size_t i = 0; i < uses.size();) {
        int64_t balance = 0;
        const uint64_t edge = uses[i] >> 1;
        for (; i < uses.size() && uses[i] >> 1 == edge; ++i) balance += uses[i] & 1 ? -1 : 1;
        open += balance != 0;
    }
    return open;
}

size_t repeatedTriangleCount(const TriangleMesh& mesh) {
    auto triangles = mesh.triangles;
    for (auto& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    tbb::parallel_sort(triangles.begin(), triangles.end());
    size_t repeated = 0;
    for (size_t i = 1; i < triangles.size(); ++i) repeated += triangles[i] == triangles[i - 1];
    return repeated;
}

double enclosedVolume(const TriangleMesh& mesh) {
    if (mesh.positions.empty()) return 0;
    const Bounds bounds = boundsOf(mesh.positions);
    const Double3 middle = (bounds.lower + bounds.upper) * 0.5;
    double six_volumes = 0;
    for (const auto& t : mesh.triangles) {
        const Double3 a = mesh.positions[t[0]] - middle, b = mesh.positions[t[1]] - middle;
        six_volumes += dot(a, cross(b, mesh.positions[t[2]] - middle));
    }
    return six_volumes / 6;
}

double surfaceArea(const TriangleMesh& mesh) {
    double twice = 0;
    for (const auto& t : mesh.triangles) {
        const Double3& a = mesh.positions[t[0]];
        twice += length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
    }
    return twice / 2;
}

}  // namespace demolish
