// SPDX-License-Identifier: Apache-2.0
// Particles as structures of arrays. Indices: the particles of all bodies one body after the other, then
// kMaxProjectiles slots for projectiles (moved by nobody while a slot is unused or its projectile has not
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

/// Who moves a particle, as the constants of one kind of step see it: substeps move what goes with its bonds,
/// contact steps move rigid fragments. What sleeps is listed by neither; who meets it sees it as its own kind
/// of step would move it.
enum class Mover : uint32_t {
    kNobody,     ///< an unused slot, or a projectile that has not started: it takes part in nothing
    kThisStep,   ///< the kind of step whose constants these are
    kOtherStep,  ///< the other kind; in a substep such a particle is carried on (BondedWork)
};

/// 1/kg, of what is held: so heavy that nothing moves it. m, its reach for colliders: it meets none.
inline constexpr double kHeldInverseMass = 1e-20, kHeldReach = -1e10;

/// Constants of a particle: what its owner needs every step, in one load of four numbers. Inverse mass and
/// mover share the first: its sign tells the mover. Only this type knows that.
template <class Real>
class alignas(4 * sizeof(Real)) ParticleConstants {
  public:
    DEM_FN ParticleConstants() {}
    /// Moved by this kind of step; by nobody where inverse_mass (1/kg, >= 0) is 0.
    DEM_FN ParticleConstants(Real inverse_mass, Real inverse_turning, Real contact_reach, Real floor_reach)
        : inverse_inertia(inverse_turning),
          contact_radius(contact_reach),
          floor_radius(floor_reach),
          signed_inverse_mass_(inverse_mass) {}

    /// Of a particle that is held or led (api/anchors.h).
    DEM_FN static ParticleConstants held(Real contact_reach) {
        return {Real(kHeldInverseMass), Real(kHeldInverseMass), contact_reach, Real(kHeldReach)};
    }

    DEM_FN bool isHeld() const { return floor_radius < Real(0); }
    /// Held itself, and not as a part of a rigid fragment that is.
    DEM_FN bool isAnchored() const { return !(inverse_inertia > Real(kHeldInverseMass)); }
    DEM_FN Mover mover() const {
        return isMovedByOther() ? Mover::kOtherStep : isMovedHere() ? Mover::kThisStep : Mover::kNobody;
    }
    DEM_FN bool isMovedHere() const { return signed_inverse_mass_ > Real(0); }
    DEM_FN bool isMovedByOther() const { return signed_inverse_mass_ < Real(0); }
    /// As the particle's own constants say it, before any kind of step.
    DEM_FN bool takesPart() const { return isMovedHere(); }
    /// 1/kg; 0: moved by nobody.
    DEM_FN Real inverseMass() const {
        return isMovedByOther() ? -signed_inverse_mass_ : signed_inverse_mass_;
    }
    /// Seen from the kind of step that does not move the particle.
    DEM_FN ParticleConstants seenByOther() const {
        return {-signed_inverse_mass_, inverse_inertia, contact_radius, floor_radius};
    }

    /// 1/(kg m^2), of I = 0.4 m R^2, R = (3 vol/4 pi)^(1/3). Of a rigid fragment's particle in contact steps
    /// its own inverse mass, 1/kg, while inverseMass() is that of its share of the fragment.
    Real inverse_inertia{};
    Real contact_radius{};  ///< m, R_c (contactRadii, models E.4)
    Real floor_radius{};    ///< m, to the farthest corner of the cell; of a sphere its radius; < 0: held

  private:
    Real signed_inverse_mass_{};
};

template <class Real>
DEM_FN Vec3<Real> lowPart(const Vec4<Real>& position, const Vec4<Real>& velocity, const Vec4<Real>& spin) {
    return {position.w, velocity.w, spin.w};
}
/// Another velocity or spin beside the low part that it carries.
template <class Real>
DEM_FN Vec4<Real> withLowOf(const Vec3<Real>& motion, const Vec4<Real>& former) {
    return withW(motion, former.w);
}
/// Rounded to one number: for drawing, lists and colliders.
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
    Buffer<ParticleConstants<Real>> constants;
    Buffer<uint32_t> owner;  ///< body number; projectile slot p: bodies + p

    StateIn<Real> in(uint32_t which) const {
        return {position[which].view(), rotation[which].view(), velocity[which].view(), spin[which].view()};
    }
    StateOut<Real> out(uint32_t which) {
        return {position[which].span(), rotation[which].span(), velocity[which].span(), spin[which].span()};
    }
};

}  // namespace demolish
