// SPDX-License-Identifier: Apache-2.0
// Closed, thick and outside out; then on the floor.
#include "sim_cuda/authoring/solid_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/model_refusal.h"

namespace demolish {
namespace {

/// Thinner is rounding, not substance.
double leastVolume(const TriangleMesh& mesh) {
    constexpr double kFlat = 1e-9;  // of the cube on the diagonal
    const Bounds bounds = boundsOf(mesh.positions);
    const double size = length(bounds.upper - bounds.lower);
    return kFlat * size * size * size;
}

}  // namespace

bool isSolid(const TriangleMesh& mesh) {
    return !mesh.triangles.empty() && openEdgeCount(mesh) == 0 && repeatedTriangleCount(mesh) == 0 &&
           enclosedVolume(mesh) > leastVolume(mesh);
}

void requireSolid(const TriangleMesh& mesh, const std::filesystem::path& file) {
    if (mesh.triangles.empty()) refuseModel(file, kNoTriangles);
    if (const size_t open = openEdgeCount(mesh))
        refuseModel(file, "is not closed: " + std::to_string(open) +
                              (open == 1 ? " open edge" : " open edges") +
                              "; fill its holes and make its faces point outwards");
    if (const size_t repeated = repeatedTriangleCount(mesh))
        refuseModel(file, "holds " + std::to_string(repeated) + (repeated == 1 ? " triangle" : " triangles") +
                              " more than once; remove the doubled surface");
    const double volume = enclosedVolume(mesh), least = leastVolume(mesh);
    if (!std::isfinite(volume) || !std::isfinite(least))
        refuseModel(file, "is too large to be a body; export it in a smaller unit");
    if (std::abs(volume) <= least) refuseModel(file, "encloses no volume; give it thickness");
    if (volume < 0) refuseModel(file, "is inside out (its volume is negative); flip its faces");
}

void turnZUp(TriangleMesh& mesh) {
    for (Double3& p : mesh.positions) p = {p.x, p.z, -p.y};
    for (auto& triangle : mesh.corners)
        for (CornerAttributes& corner : triangle)
            corner.normal = {corner.normal.x, corner.normal.z, -corner.normal.y};
}

double sizeToScale(const Double3& size) {
    constexpr double kLyingFlat = 0.05;  // height over the longest side
    const double longest = std::max({size.x, size.y, size.z});
    return size.y < kLyingFlat * longest ? longest : size.y;
}

double placementScale(const Double3& size, const MeshPlacement& placement) {
    if (!(placement.height > 0) || !std::isfinite(placement.height))
        throw UsageError("The model height must be a positive number of metres.");
    if (placement.keep_units) return placement.height * (placement.part.unit > 0 ? placement.part.unit : 1);
    return placement.height / sizeToScale(size);
}

void standOnFloor(TriangleMesh& mesh, const std::filesystem::path& file, double scale) {
    const Bounds bounds = boundsOf(mesh.positions);
    const Double3 foot{(bounds.lower.x + bounds.upper.x) / 2, bounds.lower.y,
                       (bounds.lower.z + bounds.upper.z) / 2};
    for (Double3& p : mesh.positions) p = (p - foot) * scale;
    const Bounds placed = boundsOf(mesh.positions);
    if (!isFinite(placed.lower) || !isFinite(placed.upper))
        refuseModel(file, "cannot be scaled to its height; export it in another unit");
    const Double3 size = placed.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (longest >= kShortestBody && longest <= kLongestBody) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "would be %.3g m long, and a body can have %g to %g m; choose a --height, or export it in "
                  "another unit",
                  longest, kShortestBody, kLongestBody);
    refuseModel(file, text);
}

}  // namespace demolish
