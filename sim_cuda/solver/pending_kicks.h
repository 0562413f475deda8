// SPDX-License-Identifier: Apache-2.0
// Rigid bodies that wake get what their last contact step has not given them yet (kernels/pending_kick.h).
#pragma once
#include "sim_cuda/kernels/pending_kick.h"
#include "sim_cuda/solver/rigid_params.h"
#include "sim_cuda/solver/solver_data.h"

namespace demolish {

/// Owns the sums.
template <class Backend, class Real>
class PendingKickSums {
  public:
    /// Keeps a reference to the backend.
    explicit PendingKickSums(Backend& backend) : backend_(backend) {}
    void allocate(uint32_t slots) { sums_ = backend_.template allocate<uint64_t>(6 * size_t{slots}); }

    /// After a contact step of `stride` substeps of dt s; `work`: bodies and labels.
    PendingKicks of(const RigidWork& work, Span<const uint32_t> regime, Span<const uint32_t> former,
                    uint32_t stride, double dt) {
        return {work.label, regime, former, work.body, sums_.span(), 0.5 * (stride - 1.0) * dt};
    }
    /// `params`: of substeps; `arrays`: of the present state, with what is booked of carried particles.
    void gather(const SubstepArrays<Real>& arrays, const StepParams<Real>& params, const RigidWork& work,
                const PendingKicks& pending, uint32_t stride, bool keeps_books) {
        if (!(pending.time > 0)) return;
        keeps_books ? gatherWith<true>(arrays, params, work, pending, stride)
                    : gatherWith<false>(arrays, params, work, pending, stride);
    }

  private:
    template <bool kLedger>
    void gatherWith(const SubstepArrays<Real>& arrays, const StepParams<Real>& params, const RigidWork& work,
                    const PendingKicks& pending, uint32_t stride) {
        // Substeps bring the springs on by the rest.
        StepParams<Real> contact_step = rigidParams(params, stride, stride), substep = params;
        substep.drift = contact_step.drift;
        substep.dt = contact_step.dt = static_cast<Real>(2 * pending.time);
        backend_.forEach(work.label.count,
                         GatherPendingKick<kLedger, Real>{arrays, contact_step, substep, pending, work},
                         "gather pending kick");
    }

    Backend& backend_;
    typename Backend::template Buffer<uint64_t> sums_;
};

}  // namespace demolish
