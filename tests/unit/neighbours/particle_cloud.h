// SPDX-License-Identifier: Apache-2.0
// Particles on the CPU backend for tests of lists and fragments: positions, velocities, radii and bond rows
// made by hand.
#pragma once
#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "sim_cuda/backend/cpu_backend.h"
#include "sim_cuda/solver/neighbour_lists.h"

namespace demolish::test {

struct Cloud {
    struct Item {
        Vec3<float> x, v;
        float radius = 0.01f;
        bool active = true;
    };
    std::vector<Item> items;  ///< bodies' particles, then kMaxProjectiles slots
    uint32_t in_bodies = 0;
    std::set<std::pair<uint32_t, uint32_t>> bonds;  ///< i < j, any state

    ParticleCounts counts() const { return {in_bodies, static_cast<uint32_t>(items.size())}; }
    double largestRadius() const {
        float largest = 0;
        for (uint32_t i = 0; i < in_bodies; ++i) largest = std::max(largest, items[i].radius);
        return largest;
    }
    /// Closes the list of bodies' particles: empty projectile slots follow.
    void addProjectileSlots() {
        in_bodies = static_cast<uint32_t>(items.size());
        for (uint32_t p = 0; p < kMaxProjectiles; ++p) items.push_back({{}, {}, 0.0f, false});
    }
    bool bonded(uint32_t i, uint32_t j) const { return bonds.count({std::min(i, j), std::max(i, j)}) > 0; }
};

/// The cloud's arrays on the backend.
struct CloudArrays {
    CpuBackend backend;
    ParticleArrays<CpuBackend, float> particles;
    BondArrays<CpuBackend, float> bonds;

    explicit CloudArrays(const Cloud& cloud) {
        const size_t n = cloud.items.size();
        particles.counts = cloud.counts();
        particles.position[0] = backend.allocate<Vec4<float>>(n);
        particles.velocity[0] = backend.allocate<Vec4<float>>(n);
        particles.rotation[0] = backend.allocate<Vec4<float>>(n);
        particles.spin[0] = backend.allocate<Vec4<float>>(n);
        particles.constants = backend.allocate<ParticleConstants<float>>(n);
        for (size_t i = 0; i < n; ++i) {
            const auto& item = cloud.items[i];
            particles.constants.span()[i] = {item.active ? 1.0f : 0.0f, 1.0f, item.radius, item.radius};
        }
        move(cloud);
        addBonds(cloud);
    }
    void move(const Cloud& cloud) {
        for (size_t i = 0; i < cloud.items.size(); ++i) {
            particles.position[0].span()[i] = withW(cloud.items[i].x, 0.0f);
            particles.velocity[0].span()[i] = withW(cloud.items[i].v, 0.0f);
        }
    }
    StateIn<float> state() const { return particles.in(0); }

  private:
    void addBonds(const Cloud& cloud) {
        std::vector<uint32_t> row_start{0};
        std::vector<BondLink> links;
        std::vector<std::vector<uint32_t>> rows(cloud.items.size());
        for (const auto& [i, j] : cloud.bonds) {
            rows[i].push_back(j);
            rows[j].push_back(i);
        }
        for (auto& row : rows) {
            std::sort(row.begin(), row.end());
            for (const uint32_t j : row) links.push_back({linkWord(j, PairState::kBroken), ~0u});
            row_start.push_back(static_cast<uint32_t>(links.size()));
        }
        bonds.row_start = backend.uploaded(row_start);
        bonds.link = backend.uploaded(links);
    }
};

/// `count` particles at random in a cube, radii between the two given, speeds up to `speed`.
inline Cloud randomCloud(uint32_t count, double side, double small, double large, double speed,
                         unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto draw = [&](double size) {
        return Vec3<float>{float(size * uniform(random)), float(size * uniform(random)),
                           float(size * uniform(random))};
    };
    Cloud cloud;
    for (uint32_t i = 0; i < count; ++i) {
        const double share = 0.5 * (uniform(random) + 1);
        cloud.items.push_back(
            {draw(side / 2), draw(speed), float(small + (large - small) * share * share), true});
    }
    cloud.addProjectileSlots();
    return cloud;
}

}  // namespace demolish::test
