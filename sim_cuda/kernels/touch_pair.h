// SPDX-License-Identifier: Apache-2.0
// Two bodies pressed on each other without a bond: plain contact, the faces of a broken bond, a particle on a
// plane. One law for all three (physics A.2, A.5; models E.4, E.5): spring and damper along the line of
// centres, never pulling except by adhesion, a tangential spring cut at mu N, rolling resistance. Odd in i
// and j to the last bit.
#pragma once
#include "sim_cuda/kernels/bond_pair.h"
#include "sim_cuda/physics/contact_laws.h"
#include "sim_cuda/physics/rolling_resistance.h"
#include "sim_cuda/physics/tangential_spring.h"

namespace demolish {

/// The tangential damper of a contact never exceeds this times m_e / dt. A sphere gives way to it by rolling
/// too, three and a half times as easily as to the normal damper: at low restitution the lagged damper
/// overshot in every substep, was cut at mu N, and drove piles at rest (1.5 mW in 125 cells, for ever).
inline constexpr double kShearDampingShare = 0.2;

/// Which kind of step asks for a law of touch.
enum class StepKind : uint32_t {
    kSubstep,  ///< of particles by themselves
    kContact,  ///< of rigid fragments
};

/// m/s: below this speed of approach the dampers of contact steps pass over to those of the fragment's share.
/// A fall from 2 mm; hardly a drum that rocks hits the floor harder.
inline constexpr double kRestApproach = 0.2;

/// What two particles set against their contact, or one against a plane.
template <class Real>
struct PairInertia {
    Real inverse_mass{};      ///< 1/kg, 1/m_i + 1/m_j
    Real inverse_inertia{};   ///< 1/(kg m^2), likewise; in contact steps 1/kg, as inverse_mass
    Real stiffness_share{1};  ///< of the stiffness that the step allows,
    Real damping_share{1};  ///< and of the tangential damper: less where one of the two moves in longer steps
    bool softens = false;   ///< the contact shall remember how soft it was
};

/// A particle whose inverse mass is negative stands for its share of a rigid fragment, which answers once in
/// kRigidStride substeps: a stiffness acts on it kRigidStride^2 times, a damper kRigidStride times as hard.
template <class Real>
DEM_FN PairInertia<Real> pairInertia(const ParticleConstants<Real>& i, const ParticleConstants<Real>& j) {
    if (!(i.inverse_mass < Real(0)) && !(j.inverse_mass < Real(0)))
        return {i.inverse_mass + j.inverse_mass, i.inverse_inertia + j.inverse_inertia};
    const bool i_slow = i.inverse_mass < Real(0);
    const ParticleConstants<Real>&slow = i_slow ? i : j, &fast = i_slow ? j : i;
    constexpr Real kStride = kRigidStride;
    const Real inverse = fast.inverse_mass - slow.inverse_mass;
    return {inverse, madd(kStride, slow.inverse_inertia, fast.inverse_inertia),
            inverse / (fast.inverse_mass - kStride * kStride * slow.inverse_mass),
            inverse / (fast.inverse_mass - kStride * slow.inverse_mass), true};
}

template <class Real>
struct TouchGeometry {
    Vec3<Real> normal;  ///< unit, from i to j
    Real overlap{};     ///< m, > 0
    Real arm_i{};       ///< m, from i's centre to the common point, along the normal
    Real arm_j{};       ///< m, from j's centre to it, against the normal
};

template <class Real>
struct TouchLaw {
    Real stiffness{};       ///< N/m, of the overlap; 0 for Hertz contacts, where it varies
    Real elastic{};         ///< N, repulsion of the overlap
    Real normal_damping{};  ///< N s/m
    Real shear{};           ///< N/m, k_t
    Real shear_damping{};   ///< N s/m
    Real adhesion{};        ///< N, >= 0
    Real friction{};        ///< mu
    Real rolling{};         ///< mu_r
    Real radius{};          ///< m, for rolling
    Real inertia{};         ///< kg m^2, for rolling
    bool softens = false;   ///< as in PairInertia, or a contact step
    Real resting{};         ///< N s/m, what the normal damper has more at rest, in contact steps;
    Real shear_resting{};   ///< the same of the tangential one
};

template <class Real>
struct TouchEffect {
    Wrench<Real> load;      ///< on i
    Vec3<Real> spring;      ///< m, tangential spring after the step
    Wrench<Real> damping;   ///< on i, the normal damper's share
    Wrench<Real> friction;  ///< on i, of tangential force and rolling resistance
    Real spring_energy{};   ///< J, stored in the tangential spring after the step
    Real opening{};         ///< m/s, along the normal
};

/// 1 where nothing approaches or parts, 0 from kRestApproach on. `opening`: m/s.
template <class Real>
DEM_FN Real restShare(Real opening) {
    return maxOf(Real(1) - opening * opening * Real(1 / (kRestApproach * kRestApproach)), Real(0));
}

/// N s/m.
template <class Real>
struct Dampers {
    Real normal{}, shear{};
};
template <StepKind kStep, class Real>
DEM_FN Dampers<Real> dampers(const TouchLaw<Real>& law, Real opening) {
    if constexpr (kStep == StepKind::kSubstep) return {law.normal_damping, law.shear_damping};
    const Real share = restShare(opening);
    return {madd(share, law.resting, law.normal_damping), madd(share, law.shear_resting, law.shear_damping)};
}

/// Spring as it was; i and j as in PairMotion (of which positions and rotations are not used).
template <StepKind kStep = StepKind::kSubstep, class Real>
DEM_FN TouchEffect<Real> touchEffect(const TouchGeometry<Real>& at, const TouchLaw<Real>& law,
                                     const PairMotion<Real>& pair, const Vec3<Real>& spring, Real dt) {
    const Vec3<Real> arm_i = at.arm_i * at.normal, arm_j = -at.arm_j * at.normal;
    const Vec3<Real> relative =
        (pair.velocity_j + cross(pair.spin_j, arm_j)) - (pair.velocity_i + cross(pair.spin_i, arm_i));
    const Real opening = dot(relative, at.normal);
    const Vec3<Real> slip = axpy(-opening, at.normal, relative);
    const Dampers<Real> damping = dampers<kStep>(law, opening);
    const Real normal = repulsion(law.elastic, damping.normal, -opening);
    const TangentialResult<Real> tangential =
        tangentialSpring(spring, at.normal, slip, dt, law.shear, damping.shear, law.friction * law.elastic);
    const Vec3<Real> rolling =
        rollingTorque(law.rolling, law.radius, law.elastic, law.inertia, pair.spin_j - pair.spin_i, dt);
    TouchEffect<Real> effect;
    effect.load.force = axpy(law.adhesion - normal, at.normal, tangential.force);
    effect.load.torque = cross(arm_i, effect.load.force) + rolling;
    effect.spring = tangential.spring;
    effect.damping.force = (law.elastic - normal) * at.normal;  // on the line of centres: no torque
    effect.friction = {tangential.force, cross(arm_i, tangential.force) + rolling};
    effect.opening = opening;
    effect.spring_energy = Real(0.5) * law.shear * length2(tangential.spring);
    return effect;
}

/// What is kept with a contact's spring as its last number (N/m, 0: nothing) is the least stiffness that a
/// contact step, or a rigid fragment at one end, has given it. A contact stays that soft until it parts, or
/// bonds that wake would find its overlap loaded with more than it has taken in.
template <class Real>
DEM_FN Real noStifferThan(Real kept, Real stiffness) {
    return kept > Real(0) && kept < stiffness ? kept : stiffness;
}

/// What a contact's damper and rolling resistance go by.
template <class Real>
struct OwnMass {
    Real mass{};     ///< kg, reduced
    Real inertia{};  ///< kg m^2, reduced
};
/// In contact steps the particles' own masses, as in substeps: a fragment bounces off as it does with its
/// bonds, which give back most of what they take in. Slower than kRestApproach it need not: there the damper
/// grows to that of the fragment's share, which is what the restitution asks for, and ends the bouncing.
/// Rolling resistance takes ten times as much in a step ten times as long, where the
/// fragment's share (`shared`, kg) is heavy enough for it. `radius`: m.
template <class Real>
DEM_FN OwnMass<Real> ownMass(const PairInertia<Real>& against, const StepParams<Real>& params, Real radius,
                             Real shared) {
    const Real root = inverseSqrt(against.inverse_inertia), own = root * root;
    if (params.softening == 0) return {shared, own};
    const Real turned = minOf(Real(kRigidStride) * own, Real(4) * shared);
    return {own, Real(0.4) * turned * (radius * radius)};
}

/// What kRestApproach adds to the dampers of `law`; `shared` N s/m: the normal one by the fragment's share;
/// `shear_cap` N s/m.
template <class Real>
DEM_FN void addResting(TouchLaw<Real>& law, Real shared, Real shear_cap) {
    const Real normal = maxOf(shared, law.normal_damping);
    law.resting = normal - law.normal_damping;
    law.shear_resting = minOf(normal, shear_cap) - law.shear_damping;
}

/// Contact constants by the law chosen; R* and overlap in m; `kept` as above.
template <StepKind kStep = StepKind::kSubstep, class Real>
DEM_FN TouchLaw<Real> contactTouchLaw(const PairLaw<Real>& pair, const StepParams<Real>& params, Real overlap,
                                      Real reduced_radius, const PairInertia<Real>& against,
                                      Real kept = Real(0)) {
    const Real root = inverseSqrt(against.inverse_mass), reduced_mass = root * root;
    const OwnMass<Real> own = ownMass(against, params, reduced_radius, reduced_mass);
    TouchLaw<Real> law;
    Real shared{};
    law.softens = against.softens || params.softening != 0;
    if (params.hertz != 0) {
        const Real a = contactRadius(reduced_radius, overlap);
        law.elastic = hertzForce(pair.modulus, a, overlap);
        law.normal_damping = hertzDamping(pair.damping, pair.modulus, own.mass, a);
        if constexpr (kStep == StepKind::kContact)
            shared = hertzDamping(pair.damping, pair.modulus, reduced_mass, a);
        law.shear = mindlinStiffness(pair.shear_modulus, a);
    } else {
        const Real stiffness = noStifferThan(
            kept, minOf(pair.stiffness, against.stiffness_share * (params.stiffness_cap * reduced_mass)));
        law.stiffness = stiffness;
        law.elastic = stiffness * overlap;
        law.normal_damping = linearDamping(pair.damping, stiffness, own.mass);
        if constexpr (kStep == StepKind::kContact)
            shared = linearDamping(pair.damping, stiffness, reduced_mass);
        law.shear = Real(kContactShearRatio) * stiffness;
    }
    const Real shear_cap = against.damping_share * (Real(kShearDampingShare) * reduced_mass / params.dt);
    law.shear_damping = minOf(law.normal_damping, shear_cap);
    if constexpr (kStep == StepKind::kContact) addResting(law, shared, shear_cap);
    law.adhesion = adhesionForce(pair.adhesion, reduced_radius, overlap);
    law.friction = pair.friction;
    law.rolling = pair.rolling;
    law.radius = reduced_radius;
    law.inertia = own.inertia;
    return law;
}

/// R1 R2 / (R1 + R2) with our own reciprocal.
template <class Real>
DEM_FN Real reducedRadius(Real a, Real b) {
    const Real root = inverseSqrt(a + b);
    return (a * b) * (root * root);
}

/// Never stiffer than the step allows and than was kept. Exact where nothing is capped.
template <class Real>
DEM_FN BondConstants<Real> cappedFaces(BondConstants<Real> bond, const StepParams<Real>& params,
                                       const PairInertia<Real>& against, Real kept) {
    const Real root = inverseSqrt(against.inverse_mass);
    const Real cap = against.softens ? against.stiffness_share * params.stiffness_cap : params.face_cap;
    const Real limit = noStifferThan(kept, cap * (root * root));
    if (!(bond.stiffness.normal > limit)) return bond;
    const Real share = limit / bond.stiffness.normal;
    bond.stiffness.normal = limit;
    bond.stiffness.shear = share * bond.stiffness.shear;
    return bond;
}

/// (14') (15') with the bond's own stiffnesses and dampers.
template <class Real>
DEM_FN TouchLaw<Real> brokenTouchLaw(const BondConstants<Real>& bond, const BodyLaw<Real>& body,
                                     const StepParams<Real>& params, Real overlap, Real reduced_radius,
                                     const PairInertia<Real>& against) {
    TouchLaw<Real> law;
    law.softens = against.softens || params.softening != 0;
    law.stiffness = bond.stiffness.normal;
    law.elastic = brokenRepulsion(bond.stiffness.normal, overlap);
    law.normal_damping = bond.beta_r * bond.stiffness.normal;
    law.shear = bond.stiffness.shear;
    law.shear_damping = bond.beta_r * bond.stiffness.shear;
    law.adhesion = adhesionForce(body.adhesion, reduced_radius, overlap);
    law.friction = body.friction;
    law.rolling = body.rolling;
    law.radius = reduced_radius;
    const Real root = inverseSqrt(against.inverse_mass);
    law.inertia = ownMass(against, params, reduced_radius, root * root).inertia;
    return law;
}

}  // namespace demolish
