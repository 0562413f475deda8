// SPDX-License-Identifier: Apache-2.0
// Cubic cells in rows, layers and a block; exact in volume, so that no packing has to run first.
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/substep_bench.h"
#include "sim_cuda/physics/random.h"

namespace demolish {
namespace {

constexpr uint32_t kLeastParticles = 8;
constexpr double kJitter = 0.1;     // of the spacing, so that no force is symmetric
constexpr double kEdgeShare = 0.2;  // of a cell's face: what two cells share across an edge

class Block {
  public:
    explicit Block(uint32_t n) : n_(n), h_(1.0 / n) {}

    BreakableBody make() const {
        BreakableBody body;
        body.name = "block";
        body.spacing = h_;
        body.mesh_volume = body.cells_volume = 1;
        body.mesh_area = 6;
        body.bounds_min = {-0.5, 0, -0.5};
        body.bounds_max = {0.5, 1, 0.5};
        body.particles.reserve(size_t{n_} * n_ * n_);
        visit([&](uint32_t x, uint32_t y, uint32_t z) { add(body, cell(x, y, z)); });
        body.bonds.reserve(6 * body.particles.size());
        visit([&](uint32_t x, uint32_t y, uint32_t z) { bondsOf(body, x, y, z); });
        std::sort(body.bonds.begin(), body.bonds.end(), [](const BondGeometry& a, const BondGeometry& b) {
            return a.i != b.i ? a.i < b.i : a.j < b.j;
        });
        return body;
    }

  private:
    template <class Visit>
    void visit(const Visit& visitor) const {
        for (uint32_t z = 0; z < n_; ++z)
            for (uint32_t y = 0; y < n_; ++y)
                for (uint32_t x = 0; x < n_; ++x) visitor(x, y, z);
    }

    uint32_t id(uint32_t x, uint32_t y, uint32_t z) const { return (z * n_ + y) * n_ + x; }

    void add(BreakableBody& body, const Particle& p) const {
        const auto corner = [&](double side) {
            return Double3{p.centroid.x - p.seed.x + side * h_, p.centroid.y - p.seed.y + side * h_,
                           p.centroid.z - p.seed.z + side * h_};
        };
        body.particles.push_back(p);
        appendBoxCorners(body.corners, corner(-0.5), corner(0.5));
    }

    Particle cell(uint32_t x, uint32_t y, uint32_t z) const {
        const uint64_t counter = 3 * uint64_t{id(x, y, z)};
        const auto moved = [&](uint32_t place, uint32_t axis) {
            return (place + 0.5 + kJitter * (2 * uniformOf(1, counter + axis) - 1)) * h_;
        };
        Particle p;
        p.centroid = {(x + 0.5) * h_ - 0.5, (y + 0.5) * h_, (z + 0.5) * h_ - 0.5};
        const double sx = moved(x, 0), sy = moved(y, 1), sz = moved(z, 2);
        p.seed = {sx - 0.5, sy, sz - 0.5};
        p.volume = h_ * h_ * h_;
        const double moment = p.volume * h_ * h_ / 6;
        p.inertia = {moment, moment, moment, 0, 0, 0};
        p.depth = std::min({sx, 1 - sx, sy, 1 - sy, sz, 1 - sz});
        p.lowest = y * h_;
        return p;
    }

    void bondsOf(BreakableBody& body, uint32_t x, uint32_t y, uint32_t z) const {
        const uint32_t i = id(x, y, z);
        const bool right = x + 1 < n_, up = y + 1 < n_, on = z + 1 < n_;
        if (right) bond(body, i, id(x + 1, y, z), 1);
        if (up) bond(body, i, id(x, y + 1, z), 1);
        if (on) bond(body, i, id(x, y, z + 1), 1);
        if (right && up) bond(body, i, id(x + 1, y + 1, z), kEdgeShare);
        if (up && on) bond(body, i, id(x, y + 1, z + 1), kEdgeShare);
        if (right && on) bond(body, i, id(x + 1, y, z + 1), kEdgeShare);
    }

    void bond(BreakableBody& body, uint32_t i, uint32_t j, double face_share) const {
        const Double3 a = body.particles[i].seed, b = body.particles[j].seed;
        const Double3 d{b.x - a.x, b.y - a.y, b.z - a.z};
        BondGeometry bond;
        bond.i = i;
        bond.j = j;
        bond.area = face_share * h_ * h_;
        bond.length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        bond.normal = {d.x / bond.length, d.y / bond.length, d.z / bond.length};
        bond.centroid = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
        body.bonds.push_back(bond);
    }

    uint32_t n_;
    double h_;
};

}  // namespace

std::shared_ptr<const BreakableBody> stoneBlock(uint32_t particles) {
    if (particles < kLeastParticles || particles > kMaxParticles)
        throw UsageError("a block of " + std::to_string(particles) + " particles cannot be made; ask for " +
                         std::to_string(kLeastParticles) + " to " + std::to_string(kMaxParticles));
    const auto n = static_cast<uint32_t>(std::lround(std::cbrt(static_cast<double>(particles))));
    return std::make_shared<BreakableBody>(Block(n).make());
}

}  // namespace demolish
