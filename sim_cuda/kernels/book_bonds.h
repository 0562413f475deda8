// SPDX-License-Identifier: Apache-2.0
// What the solid bonds of a fragment keep when they come to rest. For the ledger alone.
#pragma once
#include "sim_cuda/data/ledger.h"
#include "sim_cuda/data/regimes.h"
#include "sim_cuda/kernels/bond_pair.h"
#include "sim_cuda/kernels/own_particle.h"

namespace demolish {

/// One thread a particle, once regimes are chosen and before velocities are those of rigid bodies. Kinetic
/// energy of a moment is half the mass times the velocities before and after the kick (B.1). A fragment whose
/// bonds come to rest never gets that kick: what bonds have begun to give, in half a substep at the velocity
/// before it, is gone from its motion, while they keep their energy of now.
template <class Real>
struct BookBondsAtRest {
    SubstepArrays<Real> arrays;  ///< of the present state
    Span<const uint32_t> label, regime, former;
    Span<Vec4<Real>> ledger;
    double substep = 0;  ///< s

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t slot = label[i];
        if (former[slot] != wordOf(Regime::kBonded) || regime[slot] == wordOf(Regime::kBonded)) return;
        const ParticleConstants<Real> own = arrays.constants[i];
        if (!own.takesPart() || own.isHeld()) return;
        bookedDamping(ledger[i]) += Real(0.5 * substep * powerOfBonds(i));
    }

  private:
    /// W, what their springs give to this end at the velocity that it has.
    DEM_FN double powerOfBonds(uint32_t i) const {
        const LoadedState<Real> own = loadState(arrays.in, i);
        const BodyLaw<Real> body = arrays.body_laws[arrays.owner[i]];
        Vec3<Real> force{}, torque{};
        for (uint32_t s = arrays.bond_row[i]; s < arrays.bond_row[i + 1]; ++s) {
            const BondLink link = arrays.link[s];
            if (!isBonded(link)) continue;
            const BondConstants<Real> bond = bondConstants(arrays.rest[s], link.grade, body);
            const BondDeformation<Real> d =
                bondDeformation(bond.rest, pairMotion(own, loadState(arrays.in, linkedParticle(link))));
            const BondEffect<Real> pull = elasticEffect(bond.stiffness, bondLoad(bond.stiffness, d), d);
            force = force + pull.force;
            torque = torque + pull.torque_i;
        }
        return double(dot(force, xyz(own.velocity))) + double(dot(torque, xyz(own.spin)));
    }
};

}  // namespace demolish
