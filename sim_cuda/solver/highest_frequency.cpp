// SPDX-License-Identifier: Apache-2.0
// The highest frequency of a body's bonds at rest: power iteration on M^-1 K with translation and rotation
// (physics B.3).
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/physics/bond_laws.h"
#include "sim_cuda/physics/random.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {
namespace {

/// Displacement and small rotation of a particle.
struct Motion {
    Vec3<double> shift, turn;
};

/// Rounds and margin: a large body gets fewer rounds, of which the estimate falls short by more.
struct Effort {
    int rounds;
    double margin;
};
Effort effortFor(uint32_t count) {
    if (count <= 200'000) return {200, 1.01};
    return {60, 1.03};
}

class BondOperator {
  public:
    BondOperator(const SceneTables& tables, uint32_t first, uint32_t count, double shear_ratio)
        : tables_(tables), first_(first), count_(count), shear_ratio_(shear_ratio) {}

    /// y = M^-1 K x; returns x.K x and x.M x, summed over fixed blocks in order.
    std::pair<double, double> apply(const std::vector<Motion>& x, std::vector<Motion>& y) const {
        const size_t blocks = (count_ + kBlock - 1) / kBlock;
        std::vector<std::pair<double, double>> sums(blocks);
        tbb::parallel_for(size_t{0}, blocks, [&](size_t block) {
            const size_t last = std::min<size_t>(count_, (block + 1) * kBlock);
            for (size_t i = block * kBlock; i < last; ++i) {
                const Motion force = rowForce(static_cast<uint32_t>(i), x);
                const double mass = tables_.mass[first_ + i], inertia = tables_.inertia[first_ + i];
                y[i] = {(1 / mass) * force.shift, (1 / inertia) * force.turn};
                sums[block].first += dot(x[i].shift, force.shift) + dot(x[i].turn, force.turn);
                sums[block].second += mass * length2(x[i].shift) + inertia * length2(x[i].turn);
            }
        });
        std::pair<double, double> total{0, 0};
        for (const auto& [stiff, heavy] : sums) total = {total.first + stiff, total.second + heavy};
        return total;
    }

  private:
    static constexpr size_t kBlock = 512;

    /// K x of one particle: restoring force and torque of the linearised bonds (B.2 for small motions about
    /// rest).
    Motion rowForce(uint32_t i, const std::vector<Motion>& x) const {
        Motion sum;
        for (uint32_t s = tables_.row_start[first_ + i]; s < tables_.row_start[first_ + i + 1]; ++s) {
            const BondSlot& slot = tables_.slots[s];
            const Motion &a = x[i], &b = x[slot.other - first_];
            const Vec3<double> n = normalized(slot.rest), arm = 0.5 * slot.rest;
            const Vec3<double> u = (b.shift - a.shift) - cross(0.5 * (a.turn + b.turn), slot.rest);
            const Vec3<double> theta = b.turn - a.turn;
            const BondStiffness<double> k = roundBond(slot.stiffness, shear_ratio_, slot.radius);
            const double u_n = dot(u, n), theta_n = dot(theta, n);
            const Vec3<double> force = axpy((k.normal - k.shear) * u_n, n, k.shear * u);
            const Vec3<double> moment = axpy((k.torsion - k.bending) * theta_n, n, k.bending * theta);
            sum.shift = sum.shift - force;
            sum.turn = sum.turn - (moment + cross(arm, force));
        }
        return sum;
    }

    const SceneTables& tables_;
    uint32_t first_, count_;
    double shear_ratio_;
};

}  // namespace

double highestFrequency(const SceneTables& tables, uint32_t first, uint32_t count, double shear_ratio) {
    const BondOperator bonds(tables, first, count, shear_ratio);
    const Effort effort = effortFor(count);
    std::vector<Motion> x(count), y(count);
    for (uint32_t i = 0; i < count; ++i) {
        const auto random = [&](uint64_t k) { return uniformOf(0x5eedu, 6ull * i + k) - 0.5; };
        const double turn = std::sqrt(tables.mass[first + i] / tables.inertia[first + i]);
        x[i] = {{random(0), random(1), random(2)}, turn * Vec3<double>{random(3), random(4), random(5)}};
    }
    double square = 0;
    for (int round = 0; round < effort.rounds; ++round) {
        const auto [stiff, heavy] = bonds.apply(x, y);
        if (!(stiff > 0) || !(heavy > 0)) return 0;
        square = stiff / heavy;
        const double scale = 1 / square;
        for (uint32_t i = 0; i < count; ++i) x[i] = {scale * y[i].shift, scale * y[i].turn};
    }
    return effort.margin * std::sqrt(square);
}

}  // namespace demolish
