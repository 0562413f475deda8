// SPDX-License-Identifier: Apache-2.0
// Particles as structures of arrays. Indices: the particles of all bodies one body after the other, then
// kMaxProjectiles slots for projectiles (inverse mass 0 while a slot is unused or its projectile has not
// started).
#pragma once
#include "sim_cuda/api/params.h"
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// How many there are; every per-particle array has `total` elements.
struct ParticleCounts {
    uint32_t in_bodies = 0;  ///< particles of bodies: ids 0 .. in_bodies-1
    uint32_t total = 0;      ///< in_bodies + kMaxProjectiles
};

/// Position, orientation, velocity, spin at one instant; T = Vec4<Real> or const Vec4<Real>. The position is
/// the unevaluated sum of two numbers, so that the small difference of two neighbours keeps its bits far from
/// the origin: high part in `position`, low part in the last elements of position (x), velocity (y) and spin
/// (z). World frame, SI.
template <class T>
struct StateSpans {
    Span<T> position;  ///< (x y z high, x low)
    Span<T> rotation;  ///< quaternion x y z w; 1 at rest
    Span<T> velocity;  ///< (v, y low)
    Span<T> spin;      ///< (w, z low)
};
template <class Real>
using StateIn = StateSpans<const Vec4<Real>>;
template <class Real>
using StateOut = StateSpans<Vec4<Real>>;

/// Constants of a particle, one Vec4: what its owner needs every step.
template <class Real>
struct ParticleConstants {
    Real inverse_mass{};  ///< 1/kg; 0: the slot takes part in nothing; < 0: moved in the other kind of step
    /// 1/(kg m^2), of I = 0.4 m R^2, R = (3 vol/4 pi)^(1/3). Of a rigid fragment's particle in contact steps
    /// its own inverse mass, 1/kg, while inverse_mass is that of its share of the fragment.
    Real inverse_inertia{};
    Real contact_radius{};  ///< m, R_c: half the distance to the nearest bonded seed (models E.4)
    Real floor_radius{};    ///< m, R_w: against planes (models E.4, sole rule)
};
template <class Real>
DEM_FN ParticleConstants<Real> asConstants(const Vec4<Real>& a) {
    return {a.x, a.y, a.z, a.w};
}

template <class Real>
DEM_FN Vec3<Real> lowPart(const Vec4<Real>& position, const Vec4<Real>& velocity, const Vec4<Real>& spin) {
    return {position.w, velocity.w, spin.w};
}
/// Rounded to one number: for drawing, lists and planes.
template <class T>
DEM_FN auto positionOf(const StateSpans<T>& state, size_t i) {
    return xyz(state.position[i]) + lowPart(state.position[i], state.velocity[i], state.spin[i]);
}

/// Two instants of the state in turn: a substep reads one and writes the other.
template <class Backend, class Real>
struct ParticleArrays {
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    ParticleCounts counts;
    Buffer<Vec4<Real>> position[2], rotation[2], velocity[2], spin[2];
    Buffer<Vec4<Real>> constants;  ///< ParticleConstants
    Buffer<uint32_t> owner;        ///< body number; projectile slot p: bodies + p

    StateIn<Real> in(uint32_t which) const {
        return {position[which].view(), rotation[which].view(), velocity[which].view(), spin[which].view()};
    }
    StateOut<Real> out(uint32_t which) {
        return {position[which].span(), rotation[which].span(), velocity[which].span(), spin[which].span()};
    }
};

}  // namespace demolish
