// SPDX-License-Identifier: Apache-2.0
// A grid round the mesh, wide enough that what rolls over its outside stays within it.
#include "sim_cuda/api/collider_mesh.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/distance_field.h"
#include "sim_cuda/authoring/model_refusal.h"
#include "sim_cuda/authoring/repair/repair.h"
#include "sim_cuda/authoring/solid_checks.h"

namespace demolish {
namespace {

/// Cells by which the grid reaches beyond the mesh: this share of those along it, and at least so many. By an
/// irrational part of one, so that rows miss vertices that sit on round coordinates.
constexpr double kMargin = 0.1, kLeastMargin = 2, kOffRound = 0.41421356237309515;

/// Steps by which distances beyond the grid may be less than true ones; measured, 0.05.
constexpr double kInexact = 0.1;

double longestOf(const Bounds& bounds) {
    const Double3 extent = bounds.size();
    return std::max({extent.x, extent.y, extent.z});
}

/// Steps.
double marginOf(uint32_t cells) {
    return std::max(kMargin * cells, kLeastMargin) + kOffRound;
}

NodeFrame frameRound(const Bounds& bounds, uint32_t cells) {
    const double step = longestOf(bounds) / cells, margin = marginOf(cells);
    const auto nodes = [&](double length) {
        return static_cast<int>(std::ceil(length / step + 2 * margin)) + 1;
    };
    const Double3 extent = bounds.size();
    return {bounds.lower - Double3{1, 1, 1} * (margin * step), step, nodes(extent.x), nodes(extent.y),
            nodes(extent.z)};
}

void requireRoom(const Bounds& bounds, uint32_t cells, const std::filesystem::path& file) {
    if (frameRound(bounds, cells).size() <= kMostNodes) return;
    uint32_t possible = cells;
    while (possible > kLeastCells && frameRound(bounds, possible).size() > kMostNodes) --possible;
    refuseModel(file, "needs a grid of " + std::to_string(frameRound(bounds, cells).size()) +
                          " distances with " + std::to_string(cells) +
                          " cells along its longest side, and at most " + std::to_string(kMostNodes) +
                          " are possible; choose " + std::to_string(possible) + " cells or fewer");
}

Float3 inFloats(const Double3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// What repair has added has no normals of its own.
Float3 normalOr(const Float3& own, const Double3& face) {
    return own.x * own.x + own.y * own.y + own.z * own.z > 0.5f ? own : inFloats(face);
}

std::vector<float> cornersOf(const TriangleMesh& mesh) {
    std::vector<float> corners;
    corners.reserve(18 * mesh.triangles.size());
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        const Double3 &a = mesh.positions[v[0]], &b = mesh.positions[v[1]], &c = mesh.positions[v[2]];
        const Double3 face = normalized(cross(b - a, c - a));
        for (size_t k = 0; k < 3; ++k) {
            const Float3 at = inFloats(mesh.positions[v[k]]), n = normalOr(mesh.corners[t][k].normal, face);
            corners.insert(corners.end(), {at.x, at.y, at.z, n.x, n.y, n.z});
        }
    }
    return corners;
}

}  // namespace

std::shared_ptr<const ColliderMesh> makeColliderMesh(TriangleMesh mesh, const std::filesystem::path& file,
                                                     const ColliderMeshOptions& options) {
    if (options.cells < kLeastCells || options.cells > kMostCells)
        throw UsageError("A mesh collider has " + std::to_string(options.cells) +
                         " cells along its longest side; from " + std::to_string(kLeastCells) + " to " +
                         std::to_string(kMostCells) + " are possible");
    if (mesh.triangles.empty()) refuseModel(file, kNoTriangles);
    auto made = std::make_shared<ColliderMesh>();
    if (options.up == UpAxis::kZ) turnZUp(mesh);
    mesh = repairMesh(std::move(mesh), options.repair).mesh;
    requireSolid(mesh, file);
    const Bounds bounds = boundsOf(mesh.positions);
    requireRoom(bounds, options.cells, file);
    const NodeFrame frame = frameRound(bounds, options.cells);
    made->corners = cornersOf(mesh);
    DistanceNodes& nodes = made->nodes;
    nodes.origin = frame.origin;
    nodes.step = frame.step;
    nodes.margin = (marginOf(options.cells) - kInexact) * frame.step;
    nodes.count = {static_cast<uint32_t>(frame.nx), static_cast<uint32_t>(frame.ny),
                   static_cast<uint32_t>(frame.nz)};
    nodes.steps = signedDistances(mesh, MeshQueries(mesh), frame);
    const auto per_step = static_cast<float>(1 / frame.step);
    for (float& distance : nodes.steps) distance *= per_step;
    return made;
}

}  // namespace demolish
