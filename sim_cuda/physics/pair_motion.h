// SPDX-License-Identifier: Apache-2.0
// What every law of a pair takes and gives: the motion of two particles, and force and torque on the first.
#pragma once
#include "sim_cuda/physics/quaternion.h"

namespace demolish {

/// Two particles as a pair law sees them; SI, world frame.
template <class T>
struct PairMotion {
    Vec3<T> separation;  ///< x_j - x_i, m
    Quat<T> rotation_i, rotation_j;
    Vec3<T> velocity_i, velocity_j, spin_i, spin_j;
};

/// Force on i (N) and torque on i about its centre (N m).
template <class T>
struct Wrench {
    Vec3<T> force;
    Vec3<T> torque;
};

}  // namespace demolish
