// SPDX-License-Identifier: Apache-2.0
// What is awake advances: what is moved with its bonds in substeps, rigid fragments in contact steps, and how
// the two go together. Part of device_solver.h.
#pragma once
#include <algorithm>
#include <utility>

#include "sim_cuda/solver/device_solver.h"

namespace demolish {

/// n substeps of what is moved with its bonds, and the same time of what is rigid.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::runAwake(uint32_t n) {
    auto& contacts = lists_.contacts();
    const bool ledger = setup_.params.ledger, on = regimes_.on(), follows = std::exchange(lists_stand_, true);
    if (on && regimes_.movesRigid()) {
        const RigidConstants<Real> constants = regimes_.rigidConstants();
        const RigidStepOf<Backend, Real> step{data_, contacts, params_, regimes_.rigid(), constants, ledger};
        if (!regimes_.movesBonds())
            rigid_runner_.run(backend_, step, n, follows);
        else
            regimes_.carries() ? runBoth(step, n, follows) : runApart(step, n, follows);
    } else if (!on || regimes_.movesBonds()) {
        runner_.run(backend_, data_, contacts, params_, ledger, n, follows);
    }
    if (on && regimes_.movesRigid()) place_rigid_ = true;
    progress_.since_build += n;
    progress_.substeps += n;
}

/// Contact steps with the substeps between their halves: a rigid body answers to the sum of what its carried
/// particles have felt meanwhile, so that no momentum is lost between the two kinds of step. The force of a
/// contact step is that of its start; so that what the substeps add up belongs to the same moment, they see
/// carried particles from half a step before it to half a step after it (each but the first, which makes the
/// mean exact). Else contacts would lose energy that nobody books.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::runBoth(const RigidStepOf<Backend, Real>& step, uint32_t n, bool follows) {
    rigid_runner_.repeat(backend_, step, runner_, n, [&](uint32_t substeps) {
        for (uint32_t done = 0; done < substeps;) {
            const uint32_t stride = std::min(kRigidStride, substeps - done);
            StepParams<Real> params = params_;
            params.carry_time = (Real(1) - Real(0.5) * static_cast<Real>(stride)) * params.dt;
            rigid_runner_.gather(backend_, step, stride, follows || done > 0);
            runner_.runOne(backend_, data_, step.contacts, params, step.ledger, true);
            runner_.runOn(backend_, data_, step.contacts, params_, step.ledger, stride - 1);
            rigid_runner_.move(backend_, step, stride, true);
            done += stride;
        }
    });
}

/// Nothing rigid meets what is moved with its bonds before the next decision: each goes its way, on a GPU at
/// the same time. Pairs of the two that are listed all the same are left out, or it would matter who came
/// first.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::runApart(const RigidStepOf<Backend, Real>& step, uint32_t n, bool follows) {
    StepParams<Real> params = params_;
    params.leaves_out = 1;
    backend_.sideBySide([&] { runner_.run(backend_, data_, step.contacts, params, step.ledger, n, follows); },
                        [&] { rigid_runner_.run(backend_, step, n, follows); });
}

}  // namespace demolish
