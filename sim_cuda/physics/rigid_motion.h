// SPDX-License-Identifier: Apache-2.0
// A fragment that goes on as one rigid body: the motion of (16) driven by the sum of what its particles feel
// (architecture 9). In double: there are few of them, and their particles hang on them.
#pragma once
#include "sim_cuda/physics/quaternion.h"
#include "sim_cuda/physics/rigid_fit.h"

namespace demolish {

/// A^-1 of a positive definite matrix; null when it is not.
DEM_FN Sym3 inverted(const Sym3& a) {
    const double xx = a.yy * a.zz - a.yz * a.yz, xy = a.yz * a.zx - a.xy * a.zz,
                 zx = a.xy * a.yz - a.yy * a.zx;
    const double determinant = a.xx * xx + a.xy * xy + a.zx * zx;
    if (!(determinant > 0)) return {};
    const double s = 1 / determinant;
    return {s * xx, s * (a.xx * a.zz - a.zx * a.zx), s * (a.xx * a.yy - a.xy * a.xy),
            s * xy, s * (a.xy * a.zx - a.xx * a.yz), s * zx};
}

/// Substeps of bonds in one contact step of rigid fragments: their contacts are as soft as heavy, and need no
/// stress waves.
inline constexpr uint32_t kRigidStride = 10;

/// How a body falls between two kinds of step. A velocity belongs to half a step before its moment, and a
/// contact step is longer than a substep: by so much a falling body's velocity lags behind that of a falling
/// particle, half the contact step less one substep.
struct Flight {
    int32_t lag = 0;    ///< half substeps
    uint32_t free = 0;  ///< 1: nothing touched it in the last step, or hardly
};

/// World frame. `turned` starts at 1 with the body's axes along the world's.
struct RigidBody {
    Vec3<double> centre;         ///< X_c, m
    Vec3<double> velocity;       ///< V, m/s
    Vec3<double> angular;        ///< L about X_c, kg m^2/s
    Vec3<double> spin;           ///< omega, rad/s
    Quat<double> turned;         ///< since the start
    Quat<double> kicked;         ///< the same when it was kicked last
    Sym3 inverse_inertia;        ///< J^-1 at the start, 1/(kg m^2)
    double inverse_mass = 0;     ///< 1/kg
    uint32_t contact_share = 1;  ///< contacts among which its mass is shared,
    uint32_t least_share = 1;    ///< and how many at least
    double least_stand = 1;      ///< the same of contacts with colliders
    uint32_t contacts = 0;       ///< that gave it something in the step before, or will in the next one,
    uint32_t standing = 0;       ///< and how many of them with colliders
    uint32_t starts = 0;         ///< 1: the step before was a substep of its particles
    Flight flight;

    /// By an anchor: whatever pushes moves it as little as gravity does.
    DEM_FN bool isHeld() const { return !(inverse_mass > 0); }
    DEM_FN bool stands() const { return isHeld() && !(length2(velocity) + length2(spin) > 0); }
};

/// The whole of a body to its place in memory, member by member: nvcc copies what is larger than 128 bytes
/// byte by byte.
DEM_FN void store(RigidBody& to, const RigidBody& body) {
    // All members, or this does not compile.
    const auto& [centre, velocity, angular, spin, turned, kicked, inverse_inertia, inverse_mass,
                 contact_share, least_share, least_stand, contacts, standing, starts, flight] = body;
    to.centre = centre;
    to.velocity = velocity;
    to.angular = angular;
    to.spin = spin;
    to.turned = turned;
    to.kicked = kicked;
    to.inverse_inertia = inverse_inertia;
    to.inverse_mass = inverse_mass;
    to.contact_share = contact_share;
    to.least_share = least_share;
    to.least_stand = least_stand;
    to.contacts = contacts;
    to.standing = standing;
    to.starts = starts;
    to.flight = flight;
}

/// omega of J(q) omega = L.
DEM_FN Vec3<double> spinAt(const RigidBody& body, const Quat<double>& turned) {
    return rotate(turned, multiply(body.inverse_inertia, rotate(conjugate(turned), body.angular)));
}

/// Kick and drift as of one particle (physics B.1); the turn takes omega at its middle, so that without a
/// torque L is kept exactly and the energy to third order. `push` N s, `turn` N m s about the centre, `fall`
/// m/s that gravity adds, dt s of the drift.
DEM_FN void advance(RigidBody& body, const Vec3<double>& push, const Vec3<double>& turn,
                    const Vec3<double>& fall, double dt) {
    body.velocity = axpy(body.inverse_mass, push, body.velocity + fall);
    body.centre = axpy(dt, body.velocity, body.centre);
    body.angular = body.angular + turn;
    body.kicked = body.turned;
    const Quat<double> half = advanced(body.turned, spinAt(body, body.turned), 0.5 * dt);
    body.turned = advanced(body.turned, spinAt(body, half), dt);
    body.spin = spinAt(body, body.turned);
}

/// A held body goes on as it is led; dt s of the drift.
DEM_FN void lead(RigidBody& body, double dt) {
    body.centre = axpy(dt, body.velocity, body.centre);
    body.kicked = body.turned;
    if (length2(body.spin) > 0) body.turned = advanced(body.turned, body.spin, dt);
}

/// Substeps for which what touches pushes in a contact step of `stride` substeps after one of `before`: from
/// the middle of the one to the middle of the other, or a step that is shorter or longer than the one before
/// it would not keep the energy of what touches.
DEM_FN double pushedSubsteps(uint32_t before, uint32_t stride) {
    return 0.5 * (double(before) + double(stride));
}

/// Substeps of gravity in a contact step of `stride` of them: fewer in the first one of a body that was moved
/// with its bonds before. Where something touches it, gravity goes on as its contacts do, after a step of
/// `before` substeps, or what lies would be lifted and dropped wherever steps change their length.
DEM_FN double fallenSubsteps(Flight& flight, uint32_t before, uint32_t stride, bool touched) {
    const int32_t lag = flight.lag, length = static_cast<int32_t>(stride);
    flight.free = touched ? 0 : 1;
    if (!touched) {
        flight.lag = length - 1;
        return 0.5 * double(lag + 1 + length);
    }
    flight.lag = lag + length - static_cast<int32_t>(before);
    return pushedSubsteps(before, stride);
}

}  // namespace demolish
