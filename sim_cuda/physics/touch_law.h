// SPDX-License-Identifier: Apache-2.0
// The constants with which two bodies press on each other without a bond: plain contacts (1)-(4), linear or
// of Hertz, and the faces of broken bonds (14)-(15), as a step of given length can bear them (physics A.2,
// A.5; models E.4, E.5). What they do with them: touch_effect.h.
#pragma once
#include "sim_cuda/physics/bond_effect.h"
#include "sim_cuda/physics/contact_laws.h"
#include "sim_cuda/physics/rigid_motion.h"

namespace demolish {

/// Law constants of a contact between two owners (bodies, projectiles, or a body and a wall).
template <class T>
struct PairLaw {
    T stiffness{};      ///< N/m, linear law
    T damping{};        ///< c^ of the linear law, alpha of the Hertz law (physics A.2 table)
    T friction{};       ///< mu
    T rolling{};        ///< mu_r
    T adhesion{};       ///< w, J/m^2
    T modulus{};        ///< Pa, E* (Hertz law)
    T shear_modulus{};  ///< Pa, G* (Hertz law)
    T gentle{};         ///< m/s, against colliders: no slower landing of bonded cells breaks anything
};
/// What the faces of a body's broken bonds have beside the bond's own stiffness and damper.
template <class T>
struct FaceLaw {
    T friction{};  ///< mu
    T rolling{};   ///< mu_r
    T adhesion{};  ///< w, J/m^2
};

/// k_t / k_n of the linear contact law (models E.4).
inline constexpr double kContactShearRatio = 0.8;
/// A contact never gets stiffer than this times m_e / dt^2, so that it lasts nine substeps or more: light
/// slivers between stiff cells stay stable, and the strong damper of a low restitution is integrated within a
/// few per cent of its energy (at 0.3 a hard shot gained 7 % of its energy, at 0.12 it gains 2.5 %).
inline constexpr double kContactStiffnessShare = 0.12;
/// The tangential damper of a contact never exceeds this times m_e / dt. A sphere gives way to it by rolling
/// too, three and a half times as easily as to the normal damper: at low restitution the lagged damper
/// overshot in every substep, was cut at mu N, and drove piles at rest (1.5 mW in 125 cells, for ever).
inline constexpr double kShearDampingShare = 0.2;

/// Which kind of step asks for a law of touch.
enum class StepKind : uint32_t {
    kSubstep,  ///< of particles by themselves
    kContact,  ///< of rigid fragments
};

/// What the step asks of every touch.
template <class T>
struct TouchStep {
    T dt{};               ///< s
    T stiffness_cap{};    ///< 1/s^2: k <= stiffness_cap * m_e of plain contacts
    T own_cap{};          ///< 1/s^2, contact steps: stiffness_cap of a substep, for the particles' own masses
    T face_cap{T(1e30)};  ///< 1/s^2: the same of the faces of broken bonds (rigid steps are longer)
    uint32_t softening = 0;  ///< 1: contact steps; a contact remembers how soft it was
    uint32_t hertz = 0;      ///< 1: Hertz contacts
};

/// What two particles set against their contact, or one against a plane.
template <class T>
struct PairInertia {
    T inverse_mass{};      ///< 1/kg, 1/m_i + 1/m_j
    T inverse_inertia{};   ///< 1/(kg m^2), likewise; in contact steps 1/kg, as inverse_mass
    T stiffness_share{1};  ///< of the stiffness that the step allows,
    T damping_share{1};    ///< and of the tangential damper: less where one of the two moves in longer steps
    bool softens = false;  ///< the contact shall remember how soft it was
};

template <class T>
struct TouchLaw {
    T stiffness{};         ///< N/m, of the overlap; 0 for Hertz contacts, where it varies
    T elastic{};           ///< N, repulsion of the overlap
    T normal_damping{};    ///< N s/m
    T shear{};             ///< N/m, k_t
    T shear_damping{};     ///< N s/m
    T adhesion{};          ///< N, >= 0
    T friction{};          ///< mu
    T rolling{};           ///< mu_r
    T radius{};            ///< m, for rolling
    T inertia{};           ///< kg m^2, for rolling
    bool softens = false;  ///< as in PairInertia, or a contact step
    T resting{};           ///< N s/m, what the normal damper has more at rest, in contact steps;
    T shear_resting{};     ///< the same of the tangential one
};

/// What is kept with a contact's spring as its last number (N/m, 0: nothing) is the least stiffness that a
/// contact step, or a rigid fragment at one end, has given it. A contact stays that soft until it parts, or
/// bonds that wake would find its overlap loaded with more than it has taken in.
template <class T>
DEM_FN T noStifferThan(T kept, T stiffness) {
    return kept > T(0) && kept < stiffness ? kept : stiffness;
}

/// What a contact's damper and rolling resistance go by.
template <class T>
struct OwnMass {
    T mass{};     ///< kg, reduced
    T inertia{};  ///< kg m^2, reduced
};
/// In contact steps the particles' own masses, as in substeps: a fragment bounces off as it does with its
/// bonds, which give back most of what they take in. Slower than kRestApproach it need not: there the damper
/// grows to that of the fragment's share, which is what the restitution asks for, and ends the bouncing.
/// Rolling resistance takes ten times as much in a step ten times as long, where the
/// fragment's share (`shared`, kg) is heavy enough for it. `radius`: m.
template <class T>
DEM_FN OwnMass<T> ownMass(const PairInertia<T>& against, const TouchStep<T>& step, T radius, T shared) {
    const T root = inverseSqrt(against.inverse_inertia), own = root * root;
    if (step.softening == 0) return {shared, own};
    const T turned = minOf(T(kRigidStride) * own, T(4) * shared);
    return {own, T(0.4) * turned * (radius * radius)};
}

/// What kRestApproach adds to the dampers of `law`; `shared` N s/m: the normal one by the fragment's share;
/// `shear_cap` N s/m.
template <class T>
DEM_FN void addResting(TouchLaw<T>& law, T shared, T shear_cap) {
    const T normal = maxOf(shared, law.normal_damping);
    law.resting = normal - law.normal_damping;
    law.shear_resting = minOf(normal, shear_cap) - law.shear_damping;
}

/// N/m, of a linear contact that nothing has softened.
template <class T>
DEM_FN T fullStiffness(const PairLaw<T>& pair, const TouchStep<T>& step, const PairInertia<T>& against,
                       T reduced_mass) {
    return minOf(pair.stiffness, against.stiffness_share * (step.stiffness_cap * reduced_mass));
}

/// N s/m, of a contact that answers with `mass` kg; `a`: m, of Hertz; `stiffness`: N/m, of the linear law.
template <class T>
DEM_FN T contactDamping(const PairLaw<T>& pair, const TouchStep<T>& step, T stiffness, T a, T mass) {
    return step.hertz != 0 ? hertzDamping(pair.damping, pair.modulus, mass, a)
                           : linearDamping(pair.damping, stiffness, mass);
}

/// Contact constants by the law chosen: (1') (2') (3') of Hertz, or linear; R* and overlap in m; `kept` as
/// above.
template <StepKind kStep = StepKind::kSubstep, class T>
DEM_FN TouchLaw<T> contactTouchLaw(const PairLaw<T>& pair, const TouchStep<T>& step, T overlap,
                                   T reduced_radius, const PairInertia<T>& against, T kept = T(0)) {
    const T root = inverseSqrt(against.inverse_mass), reduced_mass = root * root;
    const OwnMass<T> own = ownMass(against, step, reduced_radius, reduced_mass);
    const T a = step.hertz != 0 ? contactRadius(reduced_radius, overlap) : T(0);
    TouchLaw<T> law;
    law.softens = against.softens || step.softening != 0;
    if (step.hertz != 0) {
        law.elastic = hertzForce(pair.modulus, a, overlap);
        law.shear = mindlinStiffness(pair.shear_modulus, a);
    } else {
        law.stiffness = noStifferThan(kept, fullStiffness(pair, step, against, reduced_mass));
        law.elastic = law.stiffness * overlap;
        law.shear = T(kContactShearRatio) * law.stiffness;
    }
    law.normal_damping = contactDamping(pair, step, law.stiffness, a, own.mass);
    const T shear_cap = against.damping_share * (T(kShearDampingShare) * reduced_mass / step.dt);
    law.shear_damping = minOf(law.normal_damping, shear_cap);
    if constexpr (kStep == StepKind::kContact)
        addResting(law, contactDamping(pair, step, law.stiffness, a, reduced_mass), shear_cap);
    law.adhesion = adhesionForce(pair.adhesion, reduced_radius, overlap);
    law.friction = pair.friction;
    law.rolling = pair.rolling;
    law.radius = reduced_radius;
    law.inertia = own.inertia;
    return law;
}

/// Never stiffer than the step allows and than was kept. Exact where nothing is capped.
template <class T>
DEM_FN BondConstants<T> cappedFaces(BondConstants<T> bond, const TouchStep<T>& step,
                                    const PairInertia<T>& against, T kept) {
    const T root = inverseSqrt(against.inverse_mass);
    const T cap = against.softens ? against.stiffness_share * step.stiffness_cap : step.face_cap;
    const T limit = noStifferThan(kept, cap * (root * root));
    if (!(bond.stiffness.normal > limit)) return bond;
    const T share = limit / bond.stiffness.normal;
    bond.stiffness.normal = limit;
    bond.stiffness.shear = share * bond.stiffness.shear;
    return bond;
}

/// (14') (15') with the bond's own stiffnesses and dampers.
template <class T>
DEM_FN TouchLaw<T> brokenTouchLaw(const BondConstants<T>& bond, const FaceLaw<T>& faces,
                                  const TouchStep<T>& step, T overlap, T reduced_radius,
                                  const PairInertia<T>& against) {
    TouchLaw<T> law;
    law.softens = against.softens || step.softening != 0;
    law.stiffness = bond.stiffness.normal;
    law.elastic = brokenRepulsion(bond.stiffness.normal, overlap);
    law.normal_damping = bond.beta_r * bond.stiffness.normal;
    law.shear = bond.stiffness.shear;
    law.shear_damping = bond.beta_r * bond.stiffness.shear;
    law.adhesion = adhesionForce(faces.adhesion, reduced_radius, overlap);
    law.friction = faces.friction;
    law.rolling = faces.rolling;
    law.radius = reduced_radius;
    const T root = inverseSqrt(against.inverse_mass);
    law.inertia = ownMass(against, step, reduced_radius, root * root).inertia;
    return law;
}

}  // namespace demolish
