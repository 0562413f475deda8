// SPDX-License-Identifier: Apache-2.0
// How hard a collider is to a body that lands on it with its bonds, so that it bounces as its restitution
// says and breaks where it would on a hard one (models E.4).
#pragma once
#include "sim_cuda/data/kept_spring.h"
#include "sim_cuda/kernels/own_particle.h"
#include "sim_cuda/physics/hand_over.h"

namespace demolish {

/// A bonded body gives back two thirds of the speed of a landing that breaks nothing: its floor is hard, and
/// the wave comes back from its top. Landings slower than PairLaw::gentle meet a floor that is soft, with a
/// damper near the body's own impedance, so that the wave goes out into it. From this share of that speed on
/// they are landings: what stands must not sink.
inline constexpr double kLandingShare = 0.08;
/// Stiffness of such a contact and the share of the full damper.
inline constexpr double kGentleStiffness = 0.02, kGentleDamping = 0.5;

/// Landings that are faster meet a hard floor, or bodies would break later. By the time such a body has come
/// to a stop its bonds hold what it came with. From then on they push it off a floor that is as soft as its
/// restitution is low: kReceding over the constant of its damper, from kSoftestReceding to 1.
inline constexpr double kReceding = 0.25, kSoftestReceding = 0.1;
template <class Real>
DEM_FN Real recedingStiffness(const PairLaw<Real>& wall) {
    return clampTo(Real(kReceding) / maxOf(wall.damping, Real(kReceding)), Real(kSoftestReceding), Real(1));
}

/// How a particle of a fragment moves against what it touches.
template <class Real>
struct Landing {
    Real approach{};       ///< m/s, along the normal
    Real receding{};       ///< recedingStiffness() of a touch that began faster than PairLaw::gentle; else 0
    bool is_over = false;  ///< the fragment goes away by now

    DEM_FN bool isHard() const { return receding > Real(0); }
};

/// A touch begins that is fast enough for a hard landing, or goes on that was one. `receding`: of the
/// collider; `normal`: unit, out of it. Apart, as what follows is: what rarely runs takes no registers.
template <class Real>
DEM_APART Landing<Real> hardLanding(const SubstepArrays<Real>& arrays, uint32_t particle,
                                    Real own_inverse_mass, Handed<Vec3<Real>> normal, Real approach,
                                    Real receding, bool begins) {
    const FragmentVelocities<Real>& fragments = arrays.fragments;
    if (!fragments.known() || (begins && fragments.isAlone(particle, own_inverse_mass))) return {approach};
    return {approach, receding, dot(fragments.of(particle), normal) > Real(0)};
}
/// momentum: N s.
template <class Real>
DEM_APART void pushFragment(const SubstepArrays<Real>& arrays, uint32_t particle,
                            Handed<Vec3<Real>> momentum) {
    arrays.fragments.push(particle, momentum);
}

/// Of a touch that begins now with `approach`, or what is kept of one. Only substeps, with linear contacts,
/// know hard ones.
template <StepKind kStep, class Real>
DEM_FN Landing<Real> landingOf(const PairLaw<Real>& wall, const SubstepArrays<Real>& arrays,
                               const StepParams<Real>& params, const OwnParticle<Real>& own,
                               const Vec3<Real>& normal, Real approach, const Vec4<Real>& kept) {
    if (kStep != StepKind::kSubstep || params.hertz != 0) return {approach};
    const bool begins = holdsNothing(kept) && !(approach < wall.gentle) && wall.gentle > Real(0);
    if (!begins && !isHardLanding(kept)) return {approach};
    return hardLanding(arrays, own.id, own.constants.inverseMass(), normal, approach, recedingStiffness(wall),
                       begins);
}

/// N/m that the law may not exceed: what has been kept since the touch began, or what one that begins now,
/// or from which the fragment parts, makes of `full`.
template <StepKind kStep, class Real>
DEM_FN Real softestFrom(const PairLaw<Real>& wall, const StepParams<Real>& params, Real full,
                        const Landing<Real>& landing, const Vec4<Real>& kept) {
    if (landing.is_over) return noStifferThan(softestOf(kept), landing.receding * full);
    const bool lands = kStep == StepKind::kSubstep && params.hertz == 0 && holdsNothing(kept) &&
                       landing.approach > Real(kLandingShare) * wall.gentle && landing.approach < wall.gentle;
    return lands ? Real(kGentleStiffness) * full : softestOf(kept);
}
/// 1/s: a touch that rests in contact steps gets its full stiffness back, so slowly that what is lifted does
/// not swing: with 4 a block that rocks goes on for longer. A hit is slower than kRestSpeed for a step or so
/// only.
inline constexpr double kHardening = 2;
/// What is kept of a touch that goes on, as this step takes it; `approach`: m/s. In a step shorter than the
/// one before it nothing grows that the next one would take back.
template <StepKind kStep, class Real>
DEM_FN Vec4<Real> hardened(const StepParams<Real>& params, Real approach, Vec4<Real> kept) {
    const bool rests =
        kStep == StepKind::kContact && absOf(approach) < Real(kRestSpeed) && !(params.drift > params.dt);
    if (rests && hasBeenSofter(kept)) kept.w = madd(Real(kHardening) * params.dt, kept.w, kept.w);
    return kept;
}

/// Of the full stiffness, what the damper goes by: more than the spring where the floor is soft.
template <StepKind kStep, class Real>
DEM_FN Real dampedStiffness(Real full, Real softest, Real stiffness, const Landing<Real>& landing) {
    const auto isAsSoftAs = [&](Real share) {
        return softest > Real(0) && !(softest > Real(1.001) * share * full);
    };
    if (kStep != StepKind::kSubstep) return stiffness;
    if (landing.isHard()) return isAsSoftAs(landing.receding) ? full : stiffness;
    return isAsSoftAs(Real(kGentleStiffness)) ? Real(kGentleDamping * kGentleDamping) * full : stiffness;
}

}  // namespace demolish
