// SPDX-License-Identifier: Apache-2.0
// Contact steps of rigid fragments. How they run depends on the backend: here the CPU, for CUDA see
// cuda_rigid_runner.cuh.
#pragma once
#include <algorithm>

#include "sim_cuda/backend/cpu_backend.h"
#include "sim_cuda/kernels/rigid_step.h"
#include "sim_cuda/solver/contact_steps.h"
#include "sim_cuda/solver/rigid_params.h"
#include "sim_cuda/solver/solver_data.h"

namespace demolish {

/// A contact step as both backends need it. Its loads are gathered before the substeps that carry some of the
/// particles on, its bodies moved after them.
template <class Backend, class Real>
struct RigidStepOf {
    SolverData<Backend, Real>& data;
    ContactArrays<Backend, Real>& contacts;
    const StepParams<Real>& params;  ///< of substeps
    const RigidWork& work;
    const RigidConstants<Real>& constants;
    bool ledger = false;
    uint32_t before = kRigidStride;  ///< substeps of the contact step before

    /// The arrays of a substep as contact steps use them: other constants, and both instants of the state
    /// kept the same.
    SubstepArrays<Real> arrays() const {
        SubstepArrays<Real> views = data.arrays(contacts);
        views.constants = constants.in_contact_steps;
        return views;
    }
    /// After a contact step of `previous` substeps. What carries particles pushes them and is pushed for the
    /// same time, whatever was before.
    template <bool kLedger>
    StepRigid<kLedger, Real> mover(Span<const RigidLoadsOf<Real>> loads, uint32_t previous, uint32_t stride,
                                   bool carried) const {
        return {arrays(),
                data.particles.out(data.current),
                params,
                work,
                loads,
                constants.in_contact_steps,
                constants.in_substeps,
                data.particles.constants.view(),
                carried ? stride : previous,
                stride,
                carried ? 1.0 / stride : 0.0};
    }
};

template <class Backend, class Real>
class RigidRunner;

template <class Real>
class RigidRunner<CpuBackend, Real> {
  public:
    using Step = RigidStepOf<CpuBackend, Real>;

    /// All of them, one after the other.
    void run(CpuBackend& backend, const Step& step, const ContactSteps& steps, bool) {
        uint32_t previous = step.before;
        for (uint32_t k = 0; k < steps.count(); ++k) {
            const uint32_t stride = steps.length(k);
            gather(backend, step, previous, stride, k > 0);
            move(backend, step, previous, stride, false);
            previous = stride;
        }
    }
    /// take(stride, follows) for each contact step: it starts as many substeps of the runner too.
    template <class Runner, class Take>
    void runCarrying(CpuBackend&, const Step&, const Runner&, const ContactSteps& steps, const Take& take) {
        for (uint32_t k = 0; k < steps.count(); ++k) take(steps.length(k), k > 0);
    }
    /// The two halves of one contact step with substeps that carry particles between them. On the GPU the
    /// first half may `follow` a second one.
    void gather(CpuBackend& backend, const Step& step, uint32_t previous, uint32_t stride, bool) {
        if (const size_t needed = step.work.active_at_most; load_.size() < needed)
            load_ = backend.allocate<RigidLoadsOf<Real>>(needed + needed / 2);
        step.ledger ? gatherWith<true>(backend, step, previous, stride)
                    : gatherWith<false>(backend, step, previous, stride);
    }
    void moveCarrying(CpuBackend& backend, const Step& step, uint32_t stride) {
        move(backend, step, stride, stride, true);
    }
    /// Of the moment, after a contact step of step.before substeps; nothing moves.
    Span<const RigidLoadsOf<Real>> loadsNow(CpuBackend& backend, const Step& step) {
        gather(backend, step, step.before, step.before, false);
        return load_.view();
    }

  private:
    void move(CpuBackend& backend, const Step& step, uint32_t previous, uint32_t stride, bool carried) {
        step.ledger ? moveWith<true>(backend, step, previous, stride, carried)
                    : moveWith<false>(backend, step, previous, stride, carried);
    }
    template <bool kLedger>
    void gatherWith(CpuBackend& backend, const Step& step, uint32_t previous, uint32_t stride) {
        backend.forEach(
            step.work.active_at_most,
            GatherRigidLoad<kLedger, Real>{step.arrays(), rigidParams(step.params, previous, stride),
                                           step.work, load_.span()},
            "rigid load");
    }
    template <bool kLedger>
    void moveWith(CpuBackend& backend, const Step& step, uint32_t previous, uint32_t stride, bool carried) {
        backend.forEach(step.work.fragments_at_most,
                        step.template mover<kLedger>(load_.view(), previous, stride, carried), "rigid step");
    }

    CpuBackend::Buffer<RigidLoadsOf<Real>> load_;
};

}  // namespace demolish
