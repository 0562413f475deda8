// A few bonded particles stepped with the laws themselves: the smallest solver that tests of chains and pairs
// need.
#pragma once
#include <vector>

#include "sim_cuda/physics/bond_laws.h"

namespace demolish::test {

template <class T>
struct Bond {
    size_t i = 0, j = 0;
    BondRest<T> rest;
    BondStiffness<T> stiffness;
};

template <class T>
struct BondedSet {
    std::vector<ParticleState<T>> particles;
    std::vector<Bond<T>> bonds;
    std::vector<Wrench<T>> loads;  ///< of the last call of evaluate()
    T mass{1}, inertia{1};

    /// Force and torque on every particle; from each end separately, as the solver does.
    void evaluate() {
        loads.assign(particles.size(), {});
        for (const auto& bond : bonds) {
            add(bond.i, wrenchOn(bond.i, bond.j, bond.rest, bond.stiffness));
            const BondRest<T> back{-bond.rest.normal, bond.rest.length_j, bond.rest.length_i};
            add(bond.j, wrenchOn(bond.j, bond.i, back, bond.stiffness));
        }
    }

    BondDeformation<T> deformation(const Bond<T>& bond) const {
        const auto &a = particles[bond.i], &b = particles[bond.j];
        return bondDeformation(bond.rest, b.position - a.position, a.rotation, b.rotation);
    }

    /// One leapfrog step (physics B.1).
    void step(T dt) {
        evaluate();
        for (size_t p = 0; p < particles.size(); ++p) {
            auto& s = particles[p];
            s.velocity = axpy(dt / mass, loads[p].force, s.velocity);
            s.spin = axpy(dt / inertia, loads[p].torque, s.spin);
            s.position = axpy(dt, s.velocity, s.position);
            s.rotation = advanced(s.rotation, s.spin, dt);
        }
    }

    T elasticEnergy() const {
        T sum{};
        for (const auto& bond : bonds) sum += bondEnergy(bond.stiffness, deformation(bond));
        return sum;
    }

  private:
    Wrench<T> wrenchOn(size_t self, size_t other, const BondRest<T>& rest, const BondStiffness<T>& k) const {
        const auto &a = particles[self], &b = particles[other];
        const auto d = bondDeformation(rest, b.position - a.position, a.rotation, b.rotation);
        return bondWrench(bondLoad(k, d), d);
    }
    void add(size_t p, const Wrench<T>& w) {
        loads[p].force = loads[p].force + w.force;
        loads[p].torque = loads[p].torque + w.torque;
    }
};

/// Straight chain along x: particles 0..bond_count, pitch m apart.
template <class T>
BondedSet<T> chain(size_t bond_count, T pitch, const BondStiffness<T>& k) {
    BondedSet<T> set;
    for (size_t p = 0; p <= bond_count; ++p) {
        ParticleState<T> state;
        state.position = {T(p) * pitch, T(0), T(0)};
        set.particles.push_back(state);
    }
    for (size_t b = 0; b < bond_count; ++b)
        set.bonds.push_back({b, b + 1, {{T(1), T(0), T(0)}, pitch / 2, pitch / 2}, k});
    return set;
}

/// Unit quaternion that turns by `angle` (rad) about a unit axis; exact sine and cosine.
template <class T>
Quat<T> turn(const Vec3<T>& axis, double angle) {
    const T s = T(std::sin(angle / 2));
    return {s * axis.x, s * axis.y, s * axis.z, T(std::cos(angle / 2))};
}

}  // namespace demolish::test
