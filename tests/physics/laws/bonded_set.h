// SPDX-License-Identifier: Apache-2.0
// A few bonded particles stepped with the laws themselves: the smallest solver that tests of chains and pairs
// need.
#pragma once
#include <vector>

#include "tests/physics/laws/laws.h"

namespace demolish::test {

/// Position, orientation, velocity, spin of one particle; SI, world frame.
template <class T>
struct ParticleState {
    Vec3<T> position;  ///< m
    Quat<T> rotation;  ///< 1 at rest
    Vec3<T> velocity;  ///< m/s
    Vec3<T> spin;      ///< rad/s
};

template <class T>
DEM_FN PairMotion<T> pairOf(const ParticleState<T>& i, const ParticleState<T>& j) {
    return {j.position - i.position, i.rotation, j.rotation, i.velocity, j.velocity, i.spin, j.spin};
}
/// Two particles that do not move.
template <class T>
PairMotion<T> atRest(const Vec3<T>& separation, const Quat<T>& rotation_i, const Quat<T>& rotation_j) {
    return {separation, rotation_i, rotation_j, {}, {}, {}, {}};
}

/// The bond as the other end sees it.
template <class T>
DEM_FN BondConstants<T> fromTheOtherEnd(BondConstants<T> bond) {
    bond.rest = -bond.rest;
    return bond;
}

template <class T>
struct Bond {
    size_t i = 0, j = 0;
    BondConstants<T> constants;
};

/// What a bond does to both its ends, from each separately, as the solver does.
template <class T>
struct EvaluateBonds {
    const ParticleState<T>* particles;
    const Bond<T>* bonds;
    Wrench<T>* wrenches;  ///< two a bond: on i, on j

    DEM_FN void operator()(size_t k) const {
        const Bond<T> bond = bonds[k];
        wrenches[2 * k] = wrenchOn(bond.i, bond.j, bond.constants);
        wrenches[2 * k + 1] = wrenchOn(bond.j, bond.i, fromTheOtherEnd(bond.constants));
    }

  private:
    DEM_FN Wrench<T> wrenchOn(size_t self, size_t other, const BondConstants<T>& bond) const {
        const BondEffect<T> effect = bondEffect(bond, pairOf(particles[self], particles[other]));
        return {effect.force, effect.torque_i};
    }
};

template <class T>
struct BondedSet {
    laws::Shared<ParticleState<T>> particles;
    laws::Shared<Bond<T>> bonds;
    laws::Shared<Wrench<T>> ends;  ///< of the last call of evaluate(), two a bond
    std::vector<Wrench<T>> loads;  ///< likewise, one a particle
    T mass{1}, inertia{1};

    /// Force and torque on every particle.
    void evaluate() {
        ends.resize(2 * bonds.size());
        laws::forEach(bonds.size(), EvaluateBonds<T>{particles.data(), bonds.data(), ends.data()});
        loads.assign(particles.size(), {});
        for (size_t k = 0; k < bonds.size(); ++k) {
            add(bonds[k].i, ends[2 * k]);
            add(bonds[k].j, ends[2 * k + 1]);
        }
    }

    BondDeformation<T> deformation(const Bond<T>& bond) const {
        return laws::bondDeformation(bond.constants.rest, pairOf(particles[bond.i], particles[bond.j]));
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
        for (const auto& bond : bonds) sum += laws::bondEnergy(bond.constants.stiffness, deformation(bond));
        return sum;
    }

  private:
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
        set.bonds.push_back({b, b + 1, {{pitch, T(0), T(0)}, k, T(0), T(0), T(0)}});
    return set;
}

/// Unit quaternion that turns by `angle` (rad) about a unit axis; exact sine and cosine.
template <class T>
Quat<T> turn(const Vec3<T>& axis, double angle) {
    const T s = T(std::sin(angle / 2));
    return {s * axis.x, s * axis.y, s * axis.z, T(std::cos(angle / 2))};
}

}  // namespace demolish::test
