// SPDX-License-Identifier: Apache-2.0
// A look at the state every few substeps, whose answer travels while later substeps are computed.
#pragma once
#include "sim_cuda/api/stats.h"
#include "sim_cuda/kernels/in_turn.h"
#include "sim_cuda/kernels/look_at_state.h"
#include "sim_cuda/solver/stepper.h"

namespace demolish {

/// Owns the words in which a look answers, and their way to the host.
template <class Backend, class Real>
class StateLook {
  public:
    struct Answer {
        StepStatus status = StepStatus::kOk;
        bool left_paths = false;  ///< somebody is not, or will not be, on the path that contact lists rely on
    };

    explicit StateLook(Backend& backend)
        : words_(backend.template allocate<uint32_t>(kLookWords)), reader_(backend) {}

    /// Looks at the present state, `age` s after the contact lists were built, and as far as `ahead` s on.
    /// Does not wait.
    void start(DeviceScene<Backend, Real>& scene, Stepper<Backend, Real>& stepper, double age, double ahead);
    /// Of the last look. Waits for it, and not for what was started later.
    Answer wait();

  private:
    typename Backend::template Buffer<uint32_t> words_;
    typename Backend::Reader reader_;
};

template <class Backend, class Real>
void StateLook<Backend, Real>::start(DeviceScene<Backend, Real>& scene, Stepper<Backend, Real>& stepper,
                                     double age, double ahead) {
    const uint32_t total = scene.tables.counts.total;
    const CheckPaths<Real> paths{scene.pathsNow(age, ahead), words_.span().part(kLookRebuild, 1)};
    const LookAtState<Real> look{paths, scene.data.particles.constants.view(), words_.span(),
                                 static_cast<Real>(scene.setup.params.scene_radius)};
    if (stepper.takePlacing())
        scene.backend.forEach(total, InTurn{scene.regimes.placer(scene.data, scene.fragments.clusters), look},
                              "place rigid and look at the state");
    else
        scene.backend.forEach(total, look, "look at the state");
    reader_.take(scene.backend, words_.span());
}

template <class Backend, class Real>
typename StateLook<Backend, Real>::Answer StateLook<Backend, Real>::wait() {
    const std::vector<uint32_t>& words = reader_.wait();
    return {static_cast<StepStatus>(words[kLookStatus]), words[kLookRebuild] != 0};
}

}  // namespace demolish
