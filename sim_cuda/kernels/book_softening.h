// SPDX-License-Identifier: Apache-2.0
// What contacts lose when a fragment at one of their ends becomes rigid: from then on they are as soft as
// contact steps need them, while their overlap stays. For the ledger alone.
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
            lost += lostBy(i, j, [&](const MeasureEnergy<Real>& as) {
                return as.bondSlotEnergy(loadOwn(as.arrays, i), s);
            });
        }
        for (uint32_t s = arrays.contact_row[i]; s < arrays.contact_row[i + 1]; ++s) {
            const uint32_t j = arrays.neighbour[s];
            const Vec4<Real> spring = arrays.contact_spring[s];
            if (j < i || losesNothing(i, j, spring)) continue;
            lost += lostBy(i, j, [&](const MeasureEnergy<Real>& as) {
                const OwnParticle<Real> own = loadOwn(as.arrays, i);
                return as.contactEnergy(own, j, as.spheres(own, j), spring);
            });
        }
        lost += lostToColliders(i);
        bookedDamping(ledger[i]) += lost;
    }

  private:
    DEM_FN bool isRigid(uint32_t i) const { return regime[label[i]] == wordOf(Regime::kRigid); }
    DEM_FN bool becameRigid(uint32_t i) const {
        return isRigid(i) && former[label[i]] == wordOf(Regime::kBonded);
    }
    DEM_FN bool wasRigid(uint32_t i) const { return former[label[i]] == wordOf(Regime::kRigid); }
    /// Of a contact: it has been softened before, or contact steps have not come to it yet, so that it has
    /// taken in nothing, however deep it is (MeasureEnergy). Faces of a bond that has just broken hold
    /// theirs.
    DEM_FN bool losesNothing(uint32_t i, uint32_t j, const Vec4<Real>& kept) const {
        return hasBeenSofter(kept) || (holdsNothing(kept) && (wasRigid(i) || wasRigid(j)));
    }

    template <class Energy>
    DEM_FN Real lostBy(uint32_t i, uint32_t j, const Energy& energy) const {
        if ((!becameRigid(i) && !becameRigid(j)) || label[i] == label[j]) return Real(0);
        return energy(bonded) - energy(isRigid(i) && isRigid(j) ? rigid : carried);
    }
    DEM_FN Real lostToColliders(uint32_t i) const {
        Real lost{};
        if (!becameRigid(i)) return lost;
        const OwnParticle<Real> before = loadOwn(bonded.arrays, i), after = loadOwn(rigid.arrays, i);
        forEachCollider(bonded.params.colliders, before, [&](uint32_t c, const TangentPlane<Real>& bound) {
            if (!hasBeenSofter(bonded.arrays.collider_spring[c * bonded.params.total + i]))
                lost +=
                    bonded.colliderEnergy(before, c, bound,
                                          TurnsAlone<Real>{cornersOf(bonded.arrays.corners, i), {}}) -
                    rigid.colliderEnergy(after, c, bound,
                                         TurnsFragment<Real>{work, cornersOf(rigid.arrays.corners, i), {}});
        });
        return lost;
    }
};

}  // namespace demolish
