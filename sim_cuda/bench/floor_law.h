// SPDX-License-Identifier: Apache-2.0
// The cheapest substep that still is one: linear springs and dampers on solid bonds, then a kick and a drift.
// No contacts, walls, ledger, tough cells or equal bits between devices; lengths in spacings, masses 1.
#pragma once
#include <cstdint>

#include "sim_cuda/data/vec4.h"

namespace demolish {

using FloorVector = Vec3<float>;

/// As a kernel reads it: four Vec4 from four arrays.
struct FloorState {
    FloorVector position;
    Quat<float> rotation;
    FloorVector velocity;
    FloorVector spin;
};

struct FloorLoad {
    FloorVector force, torque;
};

/// Stable with 12 bonds a particle of length about 1: the highest frequency is near 8, so that dt times it is
/// near 0.4.
struct FloorConstants {
    float step = 0.05f;
    float normal = 1, tangential = 0.3f, turning = 0.1f;  ///< stiffnesses of a bond
    float damping = 0.05f;
    float inverse_inertia = 6;  ///< of a cube of edge 1
};

/// One bond's rest vector from the row's particle to the other, and the stretch at which it breaks; a broken
/// bond has a negative one.
using FloorRest = Vec4<float>;

DEM_FN float floorInverseSqrt(float x) {
#if defined(__CUDA_ARCH__)
    return __frsqrt_rn(x);
#else
    return 1 / std::sqrt(x);
#endif
}

/// Adds what the bond does to `own`. True when its stretch is beyond the limit.
DEM_FN bool addFloorBond(const FloorState& own, const FloorState& other, const FloorRest& bond,
                         const FloorConstants& constants, FloorLoad& load) {
    const FloorVector rest = xyz(bond), apart = other.position - own.position;
    const FloorVector turned = 0.5f * (rotate(own.rotation, rest) + rotate(other.rotation, rest));
    const FloorVector stretch = apart - turned;
    const FloorVector normal = floorInverseSqrt(dot(apart, apart)) * apart;
    const float along = dot(stretch, normal);
    const FloorVector swept = cross(own.spin + other.spin, apart);
    const FloorVector approach = axpy(-0.5f, swept, other.velocity - own.velocity);
    FloorVector force = constants.tangential * stretch;
    force = axpy((constants.normal - constants.tangential) * along, normal, force);
    force = axpy(constants.damping, approach, force);
    const Quat<float> turn = multiply(other.rotation, conjugate(own.rotation));
    const float twice = turn.w < 0 ? -2.0f : 2.0f;
    load.force = load.force + force;
    load.torque = axpy(0.5f, cross(apart, force), load.torque);
    load.torque = axpy(twice * constants.turning, vectorPart(turn), load.torque);
    load.torque = axpy(0.1f * constants.damping, other.spin - own.spin, load.torque);
    return along > bond.w;
}

/// Kick, then drift with the new velocities.
DEM_FN FloorState floorMoved(const FloorState& own, const FloorLoad& load, const FloorConstants& constants) {
    FloorState next;
    next.velocity = axpy(constants.step, load.force, own.velocity);
    next.spin = axpy(constants.step * constants.inverse_inertia, load.torque, own.spin);
    next.position = axpy(constants.step, next.velocity, own.position);
    const FloorVector half = (0.5f * constants.step) * next.spin;
    const Quat<float> q = multiply({half.x, half.y, half.z, 1}, own.rotation);
    const float scale = floorInverseSqrt(dot(vectorPart(q), vectorPart(q)) + q.w * q.w);
    next.rotation = {scale * q.x, scale * q.y, scale * q.z, scale * q.w};
    return next;
}

}  // namespace demolish
