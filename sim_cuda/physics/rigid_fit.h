// SPDX-License-Identifier: Apache-2.0
// Rigid motion of a fragment from its particles: (16)-(18) of the paper, mass-weighted and with spins
// (physics A.7), so that linear and angular momentum are kept exactly. Sums in double and in a fixed order:
// the same bits on both devices.
#pragma once
#include "sim_cuda/physics/vector.h"

namespace demolish {

/// Symmetric 3x3 matrix.
struct Sym3 {
    double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
};

/// Mass (kg) and first moments of a fragment; the first of two passes over its particles.
struct MassSums {
    double mass = 0;
    Vec3<double> moment;    ///< sum m x, kg m
    Vec3<double> momentum;  ///< sum m v = P, kg m/s
};
DEM_FN MassSums massOf(double mass, const Vec3<double>& x, const Vec3<double>& v) {
    return {mass, mass * x, mass * v};
}
DEM_FN MassSums operator+(const MassSums& a, const MassSums& b) {
    return {a.mass + b.mass, a.moment + b.moment, a.momentum + b.momentum};
}
/// X_c = sum m x/M, m.
DEM_FN Vec3<double> massCentre(const MassSums& sums) {
    return (1.0 / sums.mass) * sums.moment;
}
/// V = P/M, m/s.
DEM_FN Vec3<double> meanVelocity(const MassSums& sums) {
    return (1.0 / sums.mass) * sums.momentum;
}

/// Second pass: J and L about the mass centre.
struct SpinSums {
    Sym3 inertia;          ///< sum m (r.r 1 - r r^T) + I 1, kg m^2
    Vec3<double> angular;  ///< sum m r x v + I w = L, kg m^2/s
    double kinetic = 0;    ///< sum (m v^2 + I w^2)/2 relative to the mass centre, J
};
/// One particle's part: r = x - X_c (m), v relative to V (m/s; this keeps digits), own inertia I (kg m^2) and
/// spin w (rad/s).
/// -[r]x of (17), (18) is the map w -> w x r.
DEM_FN SpinSums spinOf(double mass, double inertia, const Vec3<double>& r, const Vec3<double>& v,
                       const Vec3<double>& w) {
    const double r2 = dot(r, r);
    return {{mass * (r2 - r.x * r.x) + inertia, mass * (r2 - r.y * r.y) + inertia,
             mass * (r2 - r.z * r.z) + inertia, -mass * r.x * r.y, -mass * r.y * r.z, -mass * r.z * r.x},
            mass * cross(r, v) + inertia * w,
            0.5 * (mass * length2(v) + inertia * length2(w))};
}
DEM_FN SpinSums operator+(const SpinSums& a, const SpinSums& b) {
    return {{a.inertia.xx + b.inertia.xx, a.inertia.yy + b.inertia.yy, a.inertia.zz + b.inertia.zz,
             a.inertia.xy + b.inertia.xy, a.inertia.yz + b.inertia.yz, a.inertia.zx + b.inertia.zx},
            a.angular + b.angular,
            a.kinetic + b.kinetic};
}

/// A b for symmetric A.
DEM_FN Vec3<double> multiply(const Sym3& a, const Vec3<double>& b) {
    return {a.xx * b.x + a.xy * b.y + a.zx * b.z, a.xy * b.x + a.yy * b.y + a.yz * b.z,
            a.zx * b.x + a.yz * b.y + a.zz * b.z};
}

/// x of A x = b for positive definite A, by L D L^T; null when a pivot is not positive.
DEM_FN Vec3<double> solveSymmetric(const Sym3& a, const Vec3<double>& b) {
    if (!(a.xx > 0)) return {};
    const double l10 = a.xy / a.xx, l20 = a.zx / a.xx;
    const double d1 = a.yy - l10 * a.xy;
    if (!(d1 > 0)) return {};
    const double e21 = a.yz - l20 * a.xy, l21 = e21 / d1;
    const double d2 = a.zz - l20 * a.zx - l21 * e21;
    if (!(d2 > 0)) return {};
    const double y1 = b.y - l10 * b.x, y2 = b.z - l20 * b.x - l21 * y1;
    const double z = y2 / d2, y = y1 / d1 - l21 * z;
    return {b.x / a.xx - l10 * y - l20 * z, y, z};
}

/// Velocity of the mass centre (m/s) and spin (rad/s): M V = P, J omega = L. J is positive definite even for
/// one particle, because of its own inertia.
struct RigidMotion {
    Vec3<double> centre;    ///< m
    Vec3<double> velocity;  ///< m/s
    Vec3<double> spin;      ///< rad/s
};
DEM_FN RigidMotion rigidMotion(const MassSums& sums, const SpinSums& spins) {
    return {massCentre(sums), meanVelocity(sums), solveSymmetric(spins.inertia, spins.angular)};
}
/// What the rigid motion leaves of the kinetic energy, J: inner vibration. Never negative but for round-off.
DEM_FN double innerEnergy(const SpinSums& spins, const RigidMotion& motion) {
    return spins.kinetic - 0.5 * dot(motion.spin, spins.angular);
}
/// The same against another rigid motion: its spin (rad/s), and the velocity of the mass centre (m/s) over
/// what it has there. `mass` kg.
DEM_FN double energyAgainst(const SpinSums& spins, double mass, const Vec3<double>& spin,
                            const Vec3<double>& velocity) {
    return spins.kinetic - dot(spin, spins.angular) + 0.5 * dot(spin, multiply(spins.inertia, spin)) +
           0.5 * mass * length2(velocity);
}
/// (16) as corrected: velocity (m/s) of the fragment's point at `arm` (m) from its mass centre.
DEM_FN Vec3<double> velocityAt(const Vec3<double>& velocity, const Vec3<double>& spin,
                               const Vec3<double>& arm) {
    return velocity + cross(spin, arm);
}

}  // namespace demolish
