// SPDX-License-Identifier: Apache-2.0
// Packing by pushing overlapping spheres apart in a periodic box, then cutting a bar out of it.
#include "tests/physics/models/packed_spheres.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim_cuda/physics/random.h"
#include "sim_cuda/physics/vector.h"

namespace demolish::tests {
namespace {

using V = Vec3<double>;
constexpr double kSolidFraction = 0.60, kSpread = 0.12, kTolerance = 1e-3;

/// Spheres in a box whose opposite sides are the same.
class PeriodicBox {
  public:
    PeriodicBox(const V& sides, double diameter, uint64_t seed) : sides_(sides) {
        const double volume = sides.x * sides.y * sides.z, mean = kPi / 6 * std::pow(diameter, 3);
        const auto count = static_cast<size_t>(kSolidFraction * volume / mean);
        double filled = 0;
        for (size_t i = 0; i < count; ++i) {
            const auto draw = [&](uint64_t k) { return uniformOf(seed, 4 * i + k); };
            x.push_back({sides.x * draw(0), sides.y * draw(1), sides.z * draw(2)});
            r.push_back(0.5 * diameter * (1 + kSpread * (2 * draw(3) - 1)));
            filled += 4.0 / 3 * kPi * std::pow(r.back(), 3);
        }
        const double scale = std::cbrt(kSolidFraction * volume / filled);
        for (double& radius : r) radius *= scale;
        reach_ = 2.0 * *std::max_element(r.begin(), r.end());
    }

    /// Until no pair overlaps by more than kTolerance of its distance. False if that is not reached.
    bool relax() {
        for (int round = 0; round < 5000; ++round)
            if (pushApart() < kTolerance) return true;
        return false;
    }

    std::vector<V> x;
    std::vector<double> r;

  private:
    double pushApart() {
        std::vector<V> push(x.size());
        double worst = 0;
        forPairs([&](size_t i, size_t j) {
            V d = x[j] - x[i];
            d = {wrapped(d.x, sides_.x), wrapped(d.y, sides_.y), wrapped(d.z, sides_.z)};
            const double touch = r[i] + r[j], distance = length(d);
            if (distance >= touch) return;
            worst = std::max(worst, 1 - distance / touch);
            const V half = (0.4 * (touch - distance)) * normalized(d);
            push[i] = push[i] - half;
            push[j] = push[j] + half;
        });
        for (size_t i = 0; i < x.size(); ++i) {
            const V moved = x[i] + push[i];
            x[i] = {folded(moved.x, sides_.x), folded(moved.y, sides_.y), folded(moved.z, sides_.z)};
        }
        return worst;
    }

    static double wrapped(double d, double side) { return d - side * std::round(d / side); }
    static double folded(double at, double side) { return at - side * std::floor(at / side); }

    template <class Visit>
    void forPairs(Visit visit) {
        const std::array<int, 3> n{static_cast<int>(sides_.x / reach_), static_cast<int>(sides_.y / reach_),
                                   static_cast<int>(sides_.z / reach_)};
        std::vector<std::vector<uint32_t>> cells(static_cast<size_t>(n[0]) * n[1] * n[2]);
        const auto cell = [&](double at, double side, int count) {
            return std::min(count - 1, static_cast<int>(at / side * count));
        };
        const auto index = [&](int a, int b, int c) {
            return (static_cast<size_t>((c + n[2]) % n[2]) * n[1] + (b + n[1]) % n[1]) * n[0] +
                   (a + n[0]) % n[0];
        };
        for (uint32_t i = 0; i < x.size(); ++i)
            cells[index(cell(x[i].x, sides_.x, n[0]), cell(x[i].y, sides_.y, n[1]),
                        cell(x[i].z, sides_.z, n[2]))]
                .push_back(i);
        for (uint32_t i = 0; i < x.size(); ++i) {
            const int a = cell(x[i].x, sides_.x, n[0]), b = cell(x[i].y, sides_.y, n[1]),
                      c = cell(x[i].z, sides_.z, n[2]);
            for (int k = 0; k < 27; ++k)
                for (const uint32_t j : cells[index(a + k % 3 - 1, b + k / 3 % 3 - 1, c + k / 9 - 1)])
                    if (j > i) visit(i, j);
        }
    }

    V sides_;
    double reach_ = 0;
};

Particle sphere(const V& at, double radius) {
    Particle p;
    p.seed = p.centroid = {at.x, at.y, at.z};
    p.volume = 4.0 / 3 * kPi * std::pow(radius, 3);
    const double moment = 0.4 * p.volume * radius * radius;
    p.inertia = {moment, moment, moment, 0, 0, 0};
    p.depth = radius;
    p.lowest = at.y - radius;
    return p;
}

void bondAcrossGaps(double gap, PackedSpheres& packing) {
    BreakableBody& body = *packing.body;
    for (uint32_t i = 0; i < body.particles.size(); ++i)
        for (uint32_t j = i + 1; j < body.particles.size(); ++j) {
            const Double3 &a = body.particles[i].seed, &b = body.particles[j].seed;
            const V d{b.x - a.x, b.y - a.y, b.z - a.z};
            const double distance = length(d), touch = packing.radius[i] + packing.radius[j];
            if (distance > (1 + gap) * touch) continue;
            BondGeometry bond;
            bond.i = i;
            bond.j = j;
            bond.length = distance;
            bond.normal = {d.x / distance, d.y / distance, d.z / distance};
            bond.area = kPi * std::pow(packing.radius[i] * packing.radius[j] / touch, 2);  // a* = 1/2
            body.bonds.push_back(bond);
        }
    packing.bonds_per_particle =
        2.0 * static_cast<double>(body.bonds.size()) / static_cast<double>(body.particles.size());
}

}  // namespace

PackedSpheres packSpheres(const Double3& sides, double diameter, double gap, uint64_t seed) {
    const double margin = 3 * diameter;  // room for three cells of the search
    const V box{sides.x + margin, sides.y + margin, sides.z + margin};
    PeriodicBox periodic(box, diameter, seed);
    PackedSpheres packing;
    packing.body = std::make_shared<BreakableBody>();
    if (!periodic.relax()) return packing;
    for (size_t i = 0; i < periodic.x.size(); ++i) {
        const V& at = periodic.x[i];
        if (at.x > sides.x || at.y > sides.y || at.z > sides.z) continue;
        packing.body->particles.push_back(sphere(at - V{sides.x / 2, 0, sides.z / 2}, periodic.r[i]));
        packing.radius.push_back(periodic.r[i]);
    }
    packing.volume = sides.x * sides.y * sides.z;
    packing.body->name = "spheres";
    packing.body->spacing = std::cbrt(packing.volume / static_cast<double>(packing.radius.size()));
    bondAcrossGaps(gap, packing);
    return packing;
}

}  // namespace demolish::tests
