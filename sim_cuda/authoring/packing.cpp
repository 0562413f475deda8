// SPDX-License-Identifier: Apache-2.0
// Relaxed packing: stratified start, pair repulsion, depth projection, exact inside check, general position.
#include "sim_cuda/authoring/packing.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/seed_moves.h"

namespace demolish {
namespace {

constexpr int kIterations = 20;
constexpr double kCheckedDepth = 0.1;  // h, shallower seeds get the exact test
constexpr double kOffset = 1e-6;       // h, general position
enum Stream : uint64_t { kStratum, kJitter, kGeneralPosition = 3, kSheet };

class Packer {
  public:
    Packer(const TriangleMesh& mesh, const MeshQueries& queries, const DistanceGrid& grid,
           const SpacingField& spacing, uint64_t seed)
        : mesh_(mesh),
          queries_(queries),
          grid_(grid),
          spacing_(spacing),
          h_(spacing.coarsest()),
          seed_(seed) {}

    /// One node per stratum of the Morton list, jittered within the node (geometry.md 1 a).
    std::vector<Double3> stratified(size_t count) const {
        const std::vector<Double3>& nodes = grid_.insideNodesInMortonOrder();
        const std::vector<double> cells = cellsUpTo(nodes);
        std::vector<Double3> seeds(count);
        forEachSeed(count, [&](size_t i) {
            if (nodes.empty()) {
                seeds[i] = pointOnSurface(i);
                return;
            }
            const double at =
                (double(i) + hashRandom(seed_, kStratum, i)) / double(count) * double(nodes.size());
            const size_t node = std::min(cells.empty() ? size_t(at) : nodeAt(cells, at), nodes.size() - 1);
            seeds[i] = nodes[node] + hashRandomInCube(seed_, kJitter, i) * grid_.nodeSpacing();
        });
        return seeds;
    }

    /// Jacobi step of pair repulsion (1 b), then two depth projections (1 c).
    void relax(std::vector<Double3>& seeds, std::vector<Double3>& next) const {
        const SeedCells cells(seeds, kReach * h_);
        const SeedSpacings spacings(spacing_, seeds);
        forEachSeed(seeds.size(), [&](size_t slot) {
            const uint32_t own = cells.seed(slot);
            const Double3 push = repulsion(cells, slot, spacings, seed_, [](uint32_t) { return true; });
            next[own] = deepEnough(grid_, cells.position(slot) + push, kDepth * spacings[own]);
        });
        seeds.swap(next);
    }

    /// General position (1 e), then the exact check of seeds near the surface (1 d).
    void settle(std::vector<Double3>& seeds) const {
        // A trilinear distance is off by less than the diagonal of a cell, so deeper seeds are certainly
        // inside.
        const double checked_depth = std::max(kCheckedDepth * h_, 1.75 * grid_.nodeSpacing());
        forEachSeed(seeds.size(), [&](size_t i) {
            const Double3 offset = hashRandomInCube(seed_, kGeneralPosition, i) * (2 * kOffset * h_);
            seeds[i] += offset;
            if (-grid_.distance(seeds[i]) < checked_depth && queries_.windingNumber(seeds[i]) <= 0)
                seeds[i] = movedInside(seeds[i], offset, i);
        });
    }

  private:
    /// Share of all cells in the nodes up to each, times their number; empty where sizes are even.
    std::vector<double> cellsUpTo(const std::vector<Double3>& nodes) const {
        std::vector<double> cells;
        if (spacing_.isEven()) return cells;
        double sum = 0;
        for (const Double3& node : nodes) cells.push_back(sum += std::pow(spacing_.at(node), -3));
        for (double& upto : cells) upto *= double(nodes.size()) / sum;
        return cells;
    }
    static size_t nodeAt(const std::vector<double>& cells, double at) {
        return size_t(std::upper_bound(cells.begin(), cells.end(), at) - cells.begin());
    }

    /// Through the closest surface point, as far as the wall allows; `offset` keeps general position.
    Double3 movedInside(const Double3& seed, const Double3& offset, size_t index) const {
        const ClosestPoint closest = queries_.closestPoint(seed);
        const Double3 through = normalized(closest.point - seed);
        const Double3 inward = -faceNormal(closest.triangle);
        for (const Double3& direction : {through, inward})
            if (Double3 inside; stepInside(closest.point, direction, offset, inside)) return inside;
        constexpr uint64_t kTries = 1000;
        for (uint64_t k = 0; k < kTries; ++k) {  // a corner too sharp for either direction: go elsewhere
            const uint32_t triangle = randomTriangle(index * kTries + k);
            if (Double3 inside;
                stepInside(pointIn(triangle, index * kTries + k), -faceNormal(triangle), offset, inside))
                return inside;
        }
        throw InputFileError("The model '" + mesh_.name +
                             "' has walls too thin to hold particles; thicken them.");
    }

    bool stepInside(const Double3& surface, const Double3& direction, const Double3& offset,
                    Double3& inside) const {
        if (lengthSquared(direction) == 0) return false;
        double step = kCheckedDepth * h_;
        for (int halving = 0; halving < 24; ++halving, step /= 2) {
            inside = surface + direction * step + offset * (step / h_);
            if (queries_.windingNumber(inside) > 0) return true;
        }
        return false;
    }

    Double3 faceNormal(uint32_t triangle) const {
        const auto& t = mesh_.triangles[triangle];
        const Double3& a = mesh_.positions[t[0]];
        return normalized(cross(mesh_.positions[t[1]] - a, mesh_.positions[t[2]] - a));
    }
    uint32_t randomTriangle(uint64_t counter) const {
        return uint32_t(hashRandom(seed_, kSheet, 3 * counter) * double(mesh_.triangles.size()));
    }
    Double3 pointIn(uint32_t triangle, uint64_t counter) const {
        const double r = std::sqrt(hashRandom(seed_, kSheet, 3 * counter + 1)),
                     s = hashRandom(seed_, kSheet, 3 * counter + 2);
        const auto& t = mesh_.triangles[triangle];
        return mesh_.positions[t[0]] * (1 - r) + mesh_.positions[t[1]] * (r * (1 - s)) +
               mesh_.positions[t[2]] * (r * s);
    }
    /// Start where the solid is too thin for any grid node to lie inside.
    Double3 pointOnSurface(uint64_t counter) const { return pointIn(randomTriangle(counter), counter); }

    const TriangleMesh& mesh_;
    const MeshQueries& queries_;
    const DistanceGrid& grid_;
    const SpacingField& spacing_;
    double h_;  // m, the largest
    uint64_t seed_;
};

}  // namespace

std::vector<Double3> packSeeds(const TriangleMesh& mesh, const MeshQueries& queries, const DistanceGrid& grid,
                               const SpacingField& spacing, uint32_t count, uint64_t seed,
                               const PackingProgress& progress, const SeedShaping& shape) {
    assert(count > 0);
    const Packer packer(mesh, queries, grid, spacing, seed);
    std::vector<Double3> seeds = packer.stratified(count), next(count);
    for (int i = 0; i < kIterations; ++i) {
        if (progress && !progress(double(i) / kIterations)) throw Cancelled();
        packer.relax(seeds, next);
    }
    if (shape) shape(seeds);
    packer.settle(seeds);
    return seeds;
}

}  // namespace demolish
