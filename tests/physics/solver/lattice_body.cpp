// SPDX-License-Identifier: Apache-2.0
// Bricks of cubic cells; what a packing of the same brick would give, without the packing.
#include "tests/physics/solver/lattice_body.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/physics/random.h"

namespace demolish::tests {
namespace {

class Brick {
  public:
    Brick(uint32_t nx, uint32_t ny, uint32_t nz, double h, double jitter, uint64_t seed)
        : n_{nx, ny, nz}, h_(h), jitter_(jitter), seed_(seed) {}

    std::shared_ptr<const BreakableBody> make() {
        auto body = std::make_shared<BreakableBody>();
        body->name = "lattice";
        body->spacing = h_;
        for (uint32_t z = 0; z < n_[2]; ++z)
            for (uint32_t y = 0; y < n_[1]; ++y)
                for (uint32_t x = 0; x < n_[0]; ++x) add(*body, cell(x, y, z));
        for (uint32_t z = 0; z < n_[2]; ++z)
            for (uint32_t y = 0; y < n_[1]; ++y)
                for (uint32_t x = 0; x < n_[0]; ++x) {
                    const uint32_t i = id(x, y, z);
                    if (x + 1 < n_[0]) bond(*body, i, id(x + 1, y, z));
                    if (y + 1 < n_[1]) bond(*body, i, id(x, y + 1, z));
                    if (z + 1 < n_[2]) bond(*body, i, id(x, y, z + 1));
                }
        std::sort(body->bonds.begin(), body->bonds.end(), [](const BondGeometry& a, const BondGeometry& b) {
            return a.i != b.i ? a.i < b.i : a.j < b.j;
        });
        const double volume = h_ * h_ * h_ * static_cast<double>(body->particles.size());
        body->mesh_volume = body->cells_volume = volume;
        body->bounds_min = {-0.5 * h_ * n_[0], 0, -0.5 * h_ * n_[2]};
        body->bounds_max = {0.5 * h_ * n_[0], h_ * n_[1], 0.5 * h_ * n_[2]};
        return body;
    }

  private:
    uint32_t id(uint32_t x, uint32_t y, uint32_t z) const { return (z * n_[1] + y) * n_[0] + x; }

    void add(BreakableBody& body, const Particle& p) const {
        const auto corner = [&](double side) {
            return Double3{p.centroid.x - p.seed.x + side * h_, p.centroid.y - p.seed.y + side * h_,
                           p.centroid.z - p.seed.z + side * h_};
        };
        body.particles.push_back(p);
        appendBoxCorners(body.corners, corner(-0.5), corner(0.5));
    }

    Particle cell(uint32_t x, uint32_t y, uint32_t z) const {
        const uint64_t counter = 3ull * id(x, y, z);
        const auto shift = [&](uint64_t axis) {
            return jitter_ * h_ * (2 * uniformOf(seed_, counter + axis) - 1);
        };
        Particle p;
        p.centroid = {(x + 0.5 - 0.5 * n_[0]) * h_, (y + 0.5) * h_, (z + 0.5 - 0.5 * n_[2]) * h_};
        p.seed = {p.centroid.x + shift(0), p.centroid.y + shift(1), p.centroid.z + shift(2)};
        p.volume = h_ * h_ * h_;
        const double moment = p.volume * h_ * h_ / 6;
        p.inertia = {moment, moment, moment, 0, 0, 0};
        const auto inside = [](double at, double length) { return std::min(at, length - at); };
        p.depth = std::min({inside(p.seed.x + 0.5 * h_ * n_[0], h_ * n_[0]), inside(p.seed.y, h_ * n_[1]),
                            inside(p.seed.z + 0.5 * h_ * n_[2], h_ * n_[2])});
        p.lowest = y * h_;
        return p;
    }

    void bond(BreakableBody& body, uint32_t i, uint32_t j) const {
        const Double3 a = body.particles[i].seed, b = body.particles[j].seed;
        const Double3 d{b.x - a.x, b.y - a.y, b.z - a.z};
        BondGeometry bond;
        bond.i = i;
        bond.j = j;
        bond.area = h_ * h_;
        bond.length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        bond.normal = {d.x / bond.length, d.y / bond.length, d.z / bond.length};
        bond.centroid = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
        body.bonds.push_back(bond);
    }

    uint32_t n_[3];
    double h_, jitter_;
    uint64_t seed_;
};

}  // namespace

std::shared_ptr<const BreakableBody> latticeBody(uint32_t nx, uint32_t ny, uint32_t nz, double h,
                                                 double jitter, uint64_t seed) {
    return Brick(nx, ny, nz, h, jitter, seed).make();
}

std::shared_ptr<const BreakableBody> ballBody(double R) {
    auto body = std::make_shared<BreakableBody>();
    body->name = "ball";
    Particle p;
    p.seed = p.centroid = {0, R, 0};
    p.volume = 4.0 / 3 * kPi * R * R * R;
    const double moment = 0.4 * p.volume * R * R;
    p.inertia = {moment, moment, moment, 0, 0, 0};
    p.depth = R;
    body->particles.push_back(p);
    body->spacing = std::cbrt(p.volume);
    body->mesh_volume = body->cells_volume = p.volume;
    body->bounds_min = {-R, 0, -R};
    body->bounds_max = {R, 2 * R, R};
    return body;
}

Material brittleMaterial() {
    Material material;
    material.critical_velocity = 1;
    material.tough_cells = 12;
    return material;
}

SceneSetup freeBody(std::shared_ptr<const BreakableBody> body) {
    SceneSetup setup;
    setup.bodies.push_back({std::move(body), brittleMaterial(), {}, {}, {}, {}});
    setup.params.gravity = {0, 0, 0};
    setup.params.colliders.clear();
    return setup;
}

SceneSetup spinningBody(double spin) {
    SceneSetup setup = freeBody(latticeBody(2, 3, 5, 0.1, 0.2));
    setup.bodies[0].material.damping_ratio = 0;
    setup.bodies[0].material.critical_velocity = 1e6;
    setup.bodies[0].angular_velocity = {spin, 0, 0};
    return setup;
}

}  // namespace demolish::tests
