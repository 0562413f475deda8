// SPDX-License-Identifier: Apache-2.0
// What contacts lose when a fragment at one of their ends becomes rigid, from its bonds or from sleep: from
// then on they are as soft as contact steps need them, while their overlap stays. For the ledger alone.
#pragma once
#include "sim_cuda/data/ledger.h"
#include "sim_cuda/data/regimes.h"
#include "sim_cuda/kernels/measure_energy.h"
#include "sim_cuda/kernels/rigid_load.h"

namespace demolish {

/// One thread a particle; pairs belong to the lower id, and only those at which a fragment has just come to
/// rest inside: what they lose later is booked where it happens.
template <class Real>
struct BookSoftening {
    MeasureEnergy<Real> bonded, carried, rigid;  ///< the same state, as each kind of pair sees it
    RigidWork work;
    Span<const uint32_t> label, regime, former;
    Span<Vec4<Real>> ledger;

    DEM_FN void operator()(uint32_t i) const {
        const SubstepArrays<Real>& arrays = bonded.arrays;
        if (!(arrays.constants[i].takesPart())) return;
        Real lost{};
        for (uint32_t s = arrays.bond_row[i]; s < arrays.bond_row[i + 1]; ++s) {
            const BondLink link = arrays.link[s];
            const uint32_t j = linkedParticle(link);
            if (isBonded(link) || j < i || losesNothing(i, j, arrays.bond_spring[s])) continue;
            lost += lostBy(i, j, [&](const MeasureEnergy<Real>& seen) {
                return seen.bondSlotEnergy(loadOwn(seen.arrays, i), s);
            });
        }
        for (uint32_t s = arrays.contact_row[i]; s < arrays.contact_row[i + 1]; ++s) {
            const uint32_t j = arrays.neighbour[s];
            const Vec4<Real> spring = arrays.contact_spring[s];
            if (j < i || losesNothing(i, j, spring)) continue;
            lost += lostBy(i, j, [&](const MeasureEnergy<Real>& seen) {
                const OwnParticle<Real> own = loadOwn(seen.arrays, i);
                return seen.contactEnergy(own, j, seen.spheres(own, j), spring);
            });
        }
        lost += lostToColliders(i);
        bookedDamping(ledger[i]) += lost;
    }

  private:
    DEM_FN bool isRigid(uint32_t i) const { return regime[label[i]] == wordOf(Regime::kRigid); }
    DEM_FN bool wasRigid(uint32_t i) const { return former[label[i]] == wordOf(Regime::kRigid); }
    DEM_FN bool wasAsleep(uint32_t i) const { return former[label[i]] == wordOf(Regime::kAsleep); }
    DEM_FN bool becameRigid(uint32_t i) const { return isRigid(i) && !wasRigid(i); }
    DEM_FN bool movesByBonds(uint32_t i) const { return regime[label[i]] == wordOf(Regime::kBonded); }
    /// Of a contact: it has been softened before, or contact steps have not come to it yet, so that it has
    /// taken in nothing, however deep it is (MeasureEnergy). Faces of a bond that has just broken hold
    /// theirs.
    DEM_FN bool losesNothing(uint32_t i, uint32_t j, const Vec4<Real>& kept) const {
        return hasBeenSofter(kept) || (holdsNothing(kept) && (wasRigid(i) || wasRigid(j)));
    }

    /// What has stood has come into its overlap by no motion, though a path may just have given it one.
    DEM_FN static MeasureEnergy<Real> as(MeasureEnergy<Real> energy, bool stood) {
        energy.lets_go = energy.lets_go && !stood;
        return energy;
    }

    template <class Energy>
    DEM_FN Real lostBy(uint32_t i, uint32_t j, const Energy& energy) const {
        if ((!becameRigid(i) && !becameRigid(j)) || label[i] == label[j]) return Real(0);
        const bool stood = wasAsleep(i) && wasAsleep(j);
        return energy(as(bonded, stood)) -
               energy(as(movesByBonds(i) || movesByBonds(j) ? carried : rigid, stood));
    }
    DEM_FN Real lostToColliders(uint32_t i) const {
        Real lost{};
        if (!becameRigid(i)) return lost;
        const MeasureEnergy<Real> then = as(bonded, wasAsleep(i)), now = as(rigid, wasAsleep(i));
        const OwnParticle<Real> before = loadOwn(then.arrays, i), after = loadOwn(now.arrays, i);
        forEachCollider(then.params.colliders, before, [&](uint32_t c, const TangentPlane<Real>& bound) {
            if (!hasBeenSofter(then.arrays.collider_spring[c * then.params.total + i]))
                lost += then.colliderEnergy(before, c, bound,
                                            TurnsAlone<Real>{cornersOf(then.arrays.corners, i), {}}) -
                        now.colliderEnergy(after, c, bound,
                                           TurnsFragment<Real>{work, cornersOf(now.arrays.corners, i), {}});
        });
        return lost;
    }
};

}  // namespace demolish
