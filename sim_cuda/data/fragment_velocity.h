// SPDX-License-Identifier: Apache-2.0
// How fast each fragment that is moved with its bonds goes as a whole, in every substep: the velocity that
// was fitted when its frame started or it woke, and what colliders have added since on which it landed hard.
// Of gravity it has what half a frame brings: with that of every substep blocks at 3 m/s bounce alike to
// three digits.
#pragma once
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

/// m/s: what is added is counted in whole numbers of these, so that its order does not matter.
inline constexpr double kVelocityUnit = 1.0 / (uint64_t{1} << 40);

/// Per slot of a fragment (regimes.h). What substeps add goes into two sums in turn: one that is complete
/// can be read while the other grows, and twice the one stands for both, since a substep adds hardly
/// anything else than the one before it.
template <class Real>
struct FragmentVelocities {
    Span<const uint32_t> label;     ///< of each particle in bodies: its fragment's slot
    Span<const Vec4<Real>> start;   ///< m/s, at the start; w: 1/kg of the fragment, 0: no push counts
    Span<const uint64_t> complete;  ///< three a slot
    Span<uint64_t> growing;         ///< likewise

    DEM_FN bool known() const { return label.data != nullptr; }
    /// A cell without bonds is all of its fragment. own_inverse_mass: 1/kg.
    DEM_FN bool isAlone(uint32_t particle, Real own_inverse_mass) const {
        return start[label[particle]].w > Real(0.9) * own_inverse_mass;
    }
    DEM_FN Vec3<Real> of(uint32_t particle) const {
        const uint32_t slot = label[particle];
        const auto added = [&](uint32_t axis) {
            const auto units = static_cast<int64_t>(complete[3 * size_t{slot} + axis]);
            return Real(2 * kVelocityUnit * double(units));
        };
        return xyz(start[slot]) + Vec3<Real>{added(0), added(1), added(2)};
    }
    /// momentum: N s, that a collider gives to the particle.
    DEM_FN void push(uint32_t particle, const Vec3<Real>& momentum) const {
        const uint32_t slot = label[particle];
        add(slot, start[slot].w * momentum);
    }

  private:
    DEM_FN void add(uint32_t slot, const Vec3<Real>& velocity) const {
        const Real value[3] = {velocity.x, velocity.y, velocity.z};
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const auto units = static_cast<int64_t>(double(value[axis]) / kVelocityUnit);
            if (units != 0) atomicAddU64(&growing[3 * size_t{slot} + axis], static_cast<uint64_t>(units));
        }
    }
};

}  // namespace demolish
