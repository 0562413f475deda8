// SPDX-License-Identifier: Apache-2.0
// Relaxed packing: stratified start, pair repulsion, depth projection, exact inside check, general position.
#include "sim_cuda/authoring/packing.h"

#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/seed_cells.h"

namespace demolish {
namespace {

constexpr int kIterations = 20;
constexpr double kReach = 1.12;        // h, d0: nearer pairs repel
constexpr double kDepth = 0.45;        // h, wanted distance from the surface
constexpr double kCheckedDepth = 0.1;  // h, shallower seeds get the exact test
constexpr double kOffset = 1e-6;       // h, general position
enum Stream : uint64_t { kStratum, kJitter, kCoincident, kGeneralPosition, kSheet };

template <typename Body>
void forEachSeed(size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 256),
                      [&](const tbb::blocked_range<size_t>& range) {
                          for (size_t i = range.begin(); i < range.end(); ++i) body(i);
                      });
}

class Packer {
  public:
    Packer(const TriangleMesh& mesh, const MeshQueries& queries, const DistanceGrid& grid, double spacing,
           uint64_t seed)
        : mesh_(mesh), queries_(queries), grid_(grid), h_(spacing), seed_(seed) {}

    /// One node per stratum of the Morton list, jittered within the node (geometry.md 1 a).
    std::vector<Double3> stratified(size_t count) const {
        const std::vector<Double3>& nodes = grid_.insideNodesInMortonOrder();
        std::vector<Double3> seeds(count);
        forEachSeed(count, [&](size_t i) {
            if (nodes.empty()) {
                seeds[i] = pointOnSurface(i);
                return;
            }
            const double at =
                (double(i) + hashRandom(seed_, kStratum, i)) / double(count) * double(nodes.size());
            const size_t node = std::min(size_t(at), nodes.size() - 1);
            seeds[i] = nodes[node] + hashRandomInCube(seed_, kJitter, i) * grid_.nodeSpacing();
        });
        return seeds;
    }

    /// Jacobi step of pair repulsion (1 b), then two depth projections (1 c).
    void relax(std::vector<Double3>& seeds, std::vector<Double3>& next) const {
        const SeedCells cells(seeds, kReach * h_);
        forEachSeed(seeds.size(), [&](size_t slot) {
            Double3 p = cells.position(slot) + repulsion(cells, slot);
            for (int k = 0; k < 2; ++k) p = deeper(p);
            next[cells.seed(slot)] = p;
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
    Double3 repulsion(const SeedCells& cells, size_t slot) const {
        const double reach = kReach * h_;
        const Double3 p = cells.position(slot);
        Double3 push;
        int neighbours = 0;
        cells.visitNear(slot, [&](size_t other) {
            const Double3 apart = p - cells.position(other);
            const double squared = lengthSquared(apart);
            if (squared >= reach * reach) return;
            ++neighbours;
            const double distance = std::sqrt(squared);
            if (distance > 1e-12 * h_) {
                push += apart * ((reach - distance) / distance);
            } else {
                push += normalized(hashRandomInCube(seed_, kCoincident, cells.seed(slot))) * reach;
            }
        });
        return neighbours == 0 ? Double3{} : push * std::min(0.5, 1.6 / neighbours);
    }

    /// One projection to the wanted depth. A step that would leave it shallower (a wall too thin for it) is
    /// halved.
    Double3 deeper(const Double3& p) const {
        const double depth = -grid_.distance(p);
        double step = kDepth * h_ - depth;
        if (step <= 0) return p;
        const Double3 inward = -normalized(grid_.gradient(p));
        for (int attempt = 0; attempt < 4; ++attempt, step /= 2) {
            const Double3 moved = p + inward * step;
            if (-grid_.distance(moved) > depth) return moved;
        }
        return p;
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
    double h_;
    uint64_t seed_;
};

}  // namespace

std::vector<Double3> packSeeds(const TriangleMesh& mesh, const MeshQueries& queries, const DistanceGrid& grid,
                               double volume, uint32_t count, uint64_t seed,
                               const PackingProgress& progress) {
    assert(volume > 0 && count > 0);
    const Packer packer(mesh, queries, grid, std::cbrt(volume / count), seed);
    std::vector<Double3> seeds = packer.stratified(count), next(count);
    for (int i = 0; i < kIterations; ++i) {
        if (progress && !progress(double(i) / kIterations)) throw Cancelled();
        packer.relax(seeds, next);
    }
    packer.settle(seeds);
    return seeds;
}

}  // namespace demolish
