// SPDX-License-Identifier: Apache-2.0
// What is awake advances: what is moved with its bonds in substeps, rigid fragments in contact steps, and how
// the two go together.
#pragma once
#include <algorithm>
#include <utility>

#include "sim_cuda/kernels/kick_rigid.h"
#include "sim_cuda/solver/device_scene.h"
#include "sim_cuda/solver/rigid_runner.h"
#include "sim_cuda/solver/substep_runner.h"

namespace demolish {

/// Owns the runners of both kinds of step, and knows whether particles of rigid fragments lag behind them.
template <class Backend, class Real>
class Stepper {
  public:
    using Scene = DeviceScene<Backend, Real>;

    explicit Stepper(Backend& backend) : runner_(backend) {}

    /// GPU: records the sequences of steps that the scene may need, once with the ledger and once without.
    void recordAhead(Scene& scene);

    /// n substeps of what is moved with its bonds, and the same time of what is rigid.
    void run(Scene& scene, uint32_t n);
    /// One substep of what is moved with its bonds, and the kick of a contact step of what is rigid, that are
    /// no steps of the run: scene.state() is that after the substep, and by how much the other changes
    /// velocities lies in SubstepArrays::carried until endDry(). The ledger books the first half of the
    /// kicks. Before anything has been decided all is moved with its bonds.
    void runDry(Scene& scene);
    void endDry(Scene& scene);

    /// Something that steps read has been written since the last step, other than the state.
    void listsChange() { lists_stand_ = false; }

    /// Contact steps move only those particles of a rigid fragment that may touch something; before anybody
    /// reads the state, the others follow.
    void placeRigid(Scene& scene);
    /// True if a caller has to let them follow by itself, who then does so.
    bool takePlacing() { return std::exchange(rigid_lags_, false); }

    /// Substeps of the last contact step, 1 if what is rigid now was moved with its bonds before; part of
    /// what changes while stepping.
    uint32_t contactStride() const { return contact_stride_; }
    void resume(uint32_t contact_stride) { contact_stride_ = contact_stride; }

  private:
    void runAllDry(Scene& scene);
    using RigidStep = RigidStepOf<Backend, Real>;

    RigidStep rigidStep(Scene& scene, const RigidConstants<Real>& constants) {
        return {scene.data, scene.lists.contacts(),    scene.params,   scene.regimes.rigid(),
                constants,  scene.setup.params.ledger, contact_stride_};
    }
    void runRigid(Scene& scene, const ContactSteps& steps, bool follows);
    void runTogether(Scene& scene, const RigidStep& step, const ContactSteps& steps, bool follows);
    void runApart(Scene& scene, const RigidStep& step, const ContactSteps& steps, bool follows);

    SubstepRunner<Backend, Real> runner_;
    RigidRunner<Backend, Real> rigid_runner_;
    bool lists_stand_ =
        false;                 ///< since the last step nothing that steps read has been written but the state
    bool rigid_lags_ = false;  ///< contact steps have moved bodies whose particles have not followed yet
    uint32_t contact_stride_ = 1;
    bool recorded_ahead_[2] = {};  ///< GPU: without and with the ledger
};

template <class Backend, class Real>
void Stepper<Backend, Real>::recordAhead(Scene& scene) {
    if constexpr (Backend::kOnGpu) {
        const bool ledger = scene.setup.params.ledger;
        const uint32_t particles = scene.tables.counts.in_bodies;
        if (std::exchange(recorded_ahead_[ledger ? 1 : 0], true)) return;
        runner_.recordAhead(scene.backend, particles, ledger);
        if (scene.regimes.on())
            rigid_runner_.template recordAhead<decltype(runner_)>(scene.backend, particles, ledger);
    }
}

template <class Backend, class Real>
void Stepper<Backend, Real>::run(Scene& scene, uint32_t n) {
    const auto& regimes = scene.regimes;
    const bool follows = std::exchange(lists_stand_, true);
    if (regimes.on() && regimes.movesRigid()) {
        runRigid(scene, ContactSteps(n), follows);
    } else {
        if (!regimes.on() || regimes.movesBonds())
            runner_.run(scene.backend, scene.data, scene.lists.contacts(), scene.params,
                        scene.setup.params.ledger, n, follows);
        contact_stride_ = 1;
    }
    scene.held.forgetFormer(scene.data);
    scene.substeps += n;
}

template <class Backend, class Real>
void Stepper<Backend, Real>::runRigid(Scene& scene, const ContactSteps& steps, bool follows) {
    const RigidConstants<Real> constants = scene.regimes.rigidConstants();
    const RigidStep step = rigidStep(scene, constants);
    if (!scene.regimes.movesBonds())
        rigid_runner_.run(scene.backend, step, steps, follows);
    else
        scene.regimes.carries() ? runTogether(scene, step, steps, follows)
                                : runApart(scene, step, steps, follows);
    rigid_lags_ = true;
    contact_stride_ = steps.length(steps.count() - 1);
}

/// Contact steps with the substeps between their halves: a rigid body answers to the sum of what its carried
/// particles have felt meanwhile, so that no momentum is lost between the two kinds of step. The force of a
/// contact step is that of its start; so that what the substeps add up belongs to the same moment, they see
/// carried particles from half a step before it to half a step after it (each but the first, which makes the
/// mean exact). Else contacts would lose energy that nobody books.
template <class Backend, class Real>
void Stepper<Backend, Real>::runTogether(Scene& scene, const RigidStep& step, const ContactSteps& steps,
                                         bool follows) {
    Backend& backend = scene.backend;
    rigid_runner_.runCarrying(backend, step, runner_, steps, [&](uint32_t stride, bool follows_one) {
        StepParams<Real> params = scene.params;
        params.carry_time = (Real(1) - Real(0.5) * static_cast<Real>(stride)) * params.dt;
        rigid_runner_.gather(backend, step, stride, stride, follows || follows_one);
        runner_.runOne(backend, scene.data, step.contacts, params, step.ledger, true);
        runner_.runOn(backend, scene.data, step.contacts, scene.params, step.ledger, stride - 1);
        rigid_runner_.moveCarrying(backend, step, stride);
    });
}

/// Nothing rigid meets what is moved with its bonds before the next decision: each goes its way, on a GPU at
/// the same time. Pairs of the two that are listed all the same are left out, or it would matter who came
/// first.
template <class Backend, class Real>
void Stepper<Backend, Real>::runApart(Scene& scene, const RigidStep& step, const ContactSteps& steps,
                                      bool follows) {
    Backend& backend = scene.backend;
    StepParams<Real> params = scene.params;
    params.leaves_out = 1;
    backend.sideBySide(
        [&] {
            runner_.run(backend, scene.data, step.contacts, params, step.ledger, steps.substeps(), follows);
        },
        [&] { rigid_runner_.run(backend, step, steps, follows); });
}

/// Of all particles, as if they were moved with their bonds.
template <class Backend, class Real>
void Stepper<Backend, Real>::runAllDry(Scene& scene) {
    auto& data = scene.data;
    const BondedWork work = std::exchange(data.work, BondedWork{});
    const auto constants = std::exchange(data.constants_in_substeps, {});
    StepParams<Real> params = scene.params;
    params.booked = KickShare::kFirstHalf;
    runner_.runOne(scene.backend, data, scene.lists.contacts(), params, scene.setup.params.ledger);
    data.work = work;
    data.constants_in_substeps = constants;
}

template <class Backend, class Real>
void Stepper<Backend, Real>::runDry(Scene& scene) {
    const auto& regimes = scene.regimes;
    if (regimes.on() && !regimes.listsStand()) return runAllDry(scene);
    auto& data = scene.data;
    const bool rigid = regimes.on() && regimes.movesRigid(), carries = rigid && regimes.carries(),
               ledger = scene.setup.params.ledger;
    StepParams<Real> params = scene.params;
    params.booked = KickShare::kFirstHalf;
    params.leaves_out = rigid && !carries ? 1 : 0;
    const SubstepArrays<Real> now = scene.arrays();
    const RigidConstants<Real> constants = scene.regimes.rigidConstants();
    Span<const RigidLoadsOf<Real>> loads;
    if (rigid) loads = rigid_runner_.loadsNow(scene.backend, rigidStep(scene, constants));
    if (!regimes.on() || regimes.movesBonds())
        runner_.runOne(scene.backend, data, scene.lists.contacts(), params, ledger);
    if (rigid)
        scene.backend.forEach(regimes.rigid().active_at_most,
                              KickRigid<Real>{now, regimes.rigid(), loads, data.particles.constants.view(),
                                              static_cast<Real>(contact_stride_) * params.dt,
                                              carries ? 1u : 0u, ledger ? 1u : 0u},
                              "kick rigid");
}

template <class Backend, class Real>
void Stepper<Backend, Real>::endDry(Scene& scene) {
    auto& data = scene.data;
    scene.backend.fill(data.carried, Vec4<Real>{});
    scene.backend.fill(data.carried_tally, Vec4<Real>{});
}

template <class Backend, class Real>
void Stepper<Backend, Real>::placeRigid(Scene& scene) {
    if (takePlacing())
        scene.backend.forEach(scene.tables.counts.total,
                              scene.regimes.placer(scene.data, scene.fragments.clusters), "place rigid");
}

}  // namespace demolish
