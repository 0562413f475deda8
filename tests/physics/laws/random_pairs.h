// SPDX-License-Identifier: Apache-2.0
// Pairs of particles in random places, orientations and motion, for tests that hold for any pair.
#pragma once
#include <random>

#include "tests/physics/laws/laws.h"

namespace demolish::test {

template <class T>
Vec3<T> drawVector(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    return {T(uniform(random)), T(uniform(random)), T(uniform(random))};
}
template <class T>
Quat<T> drawRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return normalized(Quat<T>{T(normal(random)), T(normal(random)), T(normal(random)), T(normal(random))});
}

/// About 5 cm apart, moving at m/s, within a few per cent of the bond's rest shape.
template <class T>
struct BondedPair {
    PairMotion<T> motion;
    BondConstants<T> bond;
};
template <class T>
BondedPair<T> drawBondedPair(std::mt19937& random) {
    BondedPair<T> p;
    p.bond.rest = T(0.05) * normalized(drawVector<T>(random, 1));
    p.bond.stiffness = {T(8e4), T(2.4e4), T(6.4), T(3.8)};
    p.bond.radius = T(0.0178);
    p.bond.strength = T(6e4);
    p.bond.beta_r = T(1e-4);
    p.motion.rotation_i = drawRotation<T>(random);
    p.motion.rotation_j = advanced(p.motion.rotation_i, drawVector<T>(random, 30), T(1e-3));
    p.motion.separation = rotate(p.motion.rotation_i, p.bond.rest) + drawVector<T>(random, 1e-3);
    p.motion.velocity_i = drawVector<T>(random, 3);
    p.motion.velocity_j = drawVector<T>(random, 3);
    p.motion.spin_i = drawVector<T>(random, 20);
    p.motion.spin_j = drawVector<T>(random, 20);
    return p;
}

/// The pair as the other particle sees it.
template <class T>
PairMotion<T> exchanged(const PairMotion<T>& p) {
    return {-p.separation, p.rotation_j, p.rotation_i, p.velocity_j, p.velocity_i, p.spin_j, p.spin_i};
}
template <class T>
BondedPair<T> exchanged(const BondedPair<T>& p) {
    BondedPair<T> back{exchanged(p.motion), p.bond};
    back.bond.rest = -p.bond.rest;
    return back;
}

/// Two spheres pressed on each other, with what their tangential spring already holds.
template <class T>
struct TouchingPair {
    PairMotion<T> motion;
    TouchGeometry<T> geometry;
    TouchLaw<T> law;
    Vec3<T> spring;
};
template <class T>
TouchingPair<T> drawTouchingPair(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.1, 1);
    const auto some = [&](double size) { return T(size * uniform(random)); };
    TouchingPair<T> p;
    p.motion = drawBondedPair<T>(random).motion;
    p.geometry = {normalized(drawVector<T>(random, 1)), some(1e-3), some(0.03), some(0.03)};
    p.law = {some(50), some(30), some(1e4), some(20), some(3), some(0.8), some(0.3), some(0.02), some(1e-4)};
    p.spring = drawVector<T>(random, 1e-3);
    return p;
}
template <class T>
TouchingPair<T> exchanged(const TouchingPair<T>& p) {
    const TouchGeometry<T> back{-p.geometry.normal, p.geometry.overlap, p.geometry.arm_j, p.geometry.arm_i};
    return {exchanged(p.motion), back, p.law, -p.spring};
}

}  // namespace demolish::test
