// SPDX-License-Identifier: Apache-2.0
// How large a particle is for contacts: with its like (nearest seed) and with colliders (corners).
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

/// Area vectors of a closed surface add up to nothing; faces too small for a bond are missing in the sum.
constexpr double kClosedShare = 0.1;
namespace {

double squaredDistance(const Double3& a, const Double3& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
}

/// Seeds sorted into cubes of edge h, for the search of the nearest.
class SeedCubes {
  public:
    explicit SeedCubes(const BreakableBody& body) : particles_(body.particles), edge_(body.spacing) {
        low_ = particles_[0].seed;
        Double3 high = low_;
        for (const Particle& p : particles_) {
            low_ = {std::min(low_.x, p.seed.x), std::min(low_.y, p.seed.y), std::min(low_.z, p.seed.z)};
            high = {std::max(high.x, p.seed.x), std::max(high.y, p.seed.y), std::max(high.z, p.seed.z)};
        }
        const double longest = std::max({high.x - low_.x, high.y - low_.y, high.z - low_.z});
        edge_ = std::max(edge_, longest / 1000);
        if (!(edge_ > 0)) edge_ = 1;
        size_[0] = index(high.x - low_.x) + 1;
        size_[1] = index(high.y - low_.y) + 1;
        size_[2] = index(high.z - low_.z) + 1;
        sortIn();
    }

    /// m; infinite for a single seed.
    double nearestDistance(uint32_t i) const {
        double nearest2 = std::numeric_limits<double>::infinity();
        const int longest = std::max({size_[0], size_[1], size_[2]});
        for (int ring = 1; ring <= longest; ++ring) {
            searchCube(i, ring, nearest2);
            if (nearest2 <= (ring * edge_) * (ring * edge_)) break;
        }
        return std::sqrt(nearest2);
    }

  private:
    int index(double offset) const { return static_cast<int>(offset / edge_); }
    size_t cubeOf(const Double3& p) const {
        return (static_cast<size_t>(index(p.z - low_.z)) * size_[1] + index(p.y - low_.y)) * size_[0] +
               index(p.x - low_.x);
    }

    void sortIn() {
        start_.assign(static_cast<size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
        for (const Particle& p : particles_) ++start_[cubeOf(p.seed) + 1];
        for (size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
        std::vector<uint32_t> next(start_.begin(), start_.end() - 1);
        order_.resize(particles_.size());
        for (uint32_t i = 0; i < particles_.size(); ++i) order_[next[cubeOf(particles_[i].seed)]++] = i;
    }

    void searchCube(uint32_t i, int ring, double& nearest2) const {
        const Double3 p = particles_[i].seed;
        const int cx = index(p.x - low_.x), cy = index(p.y - low_.y), cz = index(p.z - low_.z);
        for (int z = std::max(cz - ring, 0); z <= std::min(cz + ring, size_[2] - 1); ++z)
            for (int y = std::max(cy - ring, 0); y <= std::min(cy + ring, size_[1] - 1); ++y) {
                const size_t row = (static_cast<size_t>(z) * size_[1] + y) * size_[0];
                const uint32_t first = start_[row + std::max(cx - ring, 0)];
                const uint32_t last = start_[row + std::min(cx + ring, size_[0] - 1) + 1];
                for (uint32_t k = first; k < last; ++k)
                    if (order_[k] != i)
                        nearest2 = std::min(nearest2, squaredDistance(p, particles_[order_[k]].seed));
            }
    }
    const std::vector<Particle>& particles_;
    double edge_;
    Double3 low_;
    int size_[3] = {};
    std::vector<uint32_t> start_, order_;
};

double sphereRadius(double volume) {
    return std::cbrt(3 * volume / (4 * kPi));
}

}  // namespace

std::vector<double> contactRadii(const BreakableBody& body) {
    const SeedCubes cubes(body);
    std::vector<double> radii(body.particles.size());
    tbb::parallel_for(size_t{0}, radii.size(), [&](size_t i) {
        radii[i] = body.particles[i].contact_radius;
        if (radii[i] > 0) return;
        const double nearest = cubes.nearestDistance(static_cast<uint32_t>(i));
        radii[i] = std::min(nearest / 2, sphereRadius(body.particles[i].volume));
    });
    return radii;
}

std::vector<double> floorRadii(const BreakableBody& body) {
    std::vector<double> radii(body.particles.size());
    const CellCorners& corners = body.corners;
    for (size_t i = 0; i < radii.size(); ++i) {
        const Particle& p = body.particles[i];
        radii[i] = p.contact_radius > 0 ? p.contact_radius : std::min(p.depth, sphereRadius(p.volume));
        if (corners.start.empty()) continue;
        radii[i] = 0;
        for (uint32_t c = corners.start[i]; c < corners.start[i + 1]; ++c)
            radii[i] = std::max(radii[i], std::sqrt(squaredDistance(corners.from_seed[c], {})));
    }
    return radii;
}

std::vector<uint32_t> buriedParticles(const BreakableBody& body) {
    const size_t count = body.particles.size();
    std::vector<Vec3<double>> open(count);
    std::vector<double> area(count, 0.0);
    for (const BondGeometry& bond : body.bonds) {
        const Vec3<double> face = bond.area * Vec3<double>{bond.normal.x, bond.normal.y, bond.normal.z};
        open[bond.i] = open[bond.i] + face;
        open[bond.j] = open[bond.j] - face;
        area[bond.i] += bond.area;
        area[bond.j] += bond.area;
    }
    std::vector<uint32_t> buried(count);
    for (size_t i = 0; i < count; ++i) {
        const Particle& p = body.particles[i];
        const double spacing = body.cell_spacing.empty() ? body.spacing : body.cell_spacing[i];
        const bool deep = p.depth > spacing && !(p.contact_radius > 0);
        buried[i] = deep && length(open[i]) < kClosedShare * area[i] ? 1 : 0;
    }
    return buried;
}

}  // namespace demolish
