// SPDX-License-Identifier: Apache-2.0
// Particles that have left the paths of the contact lists get new ones; the lists stay, as long as they can.
#pragma once
#include "sim_cuda/kernels/strayed_paths.h"
#include "sim_cuda/solver/device_scene.h"

namespace demolish {

/// Owns the list of those who have strayed, and of what the contact rows lack for them.
template <class Backend, class Real>
class StrayPaths {
  public:
    struct Answer {
        bool lists_hold = false;  ///< false: too many; the lists must be built anew
        double decide_within =
            0;  ///< s; very large: nobody meets what the last decision has not reckoned with
    };

    explicit StrayPaths(Backend& backend)
        : words_(backend.template allocate<uint32_t>(kStrayWords)),
          strayed_(backend.template allocate<uint32_t>(kMostStrayed)),
          lacking_(backend.template allocate<uint64_t>(kMostInserted)),
          reader_(backend) {}

    /// `elapsed` s after the lists were built, with lists that hold for `ahead` s more. Waits.
    Answer restart(DeviceScene<Backend, Real>& scene, double elapsed, double ahead);

  private:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    Buffer<uint32_t> words_, strayed_;
    Buffer<uint64_t> lacking_;  ///< entries of contact rows
    typename Backend::Reader reader_;
};

template <class Backend, class Real>
typename StrayPaths<Backend, Real>::Answer StrayPaths<Backend, Real>::restart(
    DeviceScene<Backend, Real>& scene, double elapsed, double ahead) {
    constexpr uint32_t kThreads = Backend::kOnGpu ? 8 : 1;
    const uint32_t total = scene.tables.counts.total;
    auto& contacts = scene.lists.contacts();
    const auto& regimes = scene.regimes;
    const PathsNow<Real> paths = scene.pathsNow(elapsed, ahead);
    scene.backend.forEach(total, ListStrayed<Real>{paths, strayed_.span(), words_.span()},
                          "list the strayed");
    scene.backend.forEach(
        size_t{total} * kThreads,
        SeeStrayed<kThreads, Real>{
            paths, scene.data.bonds.in(), contacts.in(), scene.fragments.clusters.fragment(),
            regimes.on() ? regimes.regime() : Span<const uint32_t>{}, scene.data.particles.constants.view(),
            scene.params.colliders, length(scene.params.gravity),
            static_cast<Real>(scene.lists.horizon() - elapsed), static_cast<Real>(regimes.gentlestHit()),
            scene.tables.counts.in_bodies, strayed_.view(), lacking_.span(), words_.span()},
        "see the strayed");
    scene.backend.forEach(
        kMostStrayed,
        RestartStrayed<Real>{paths, strayed_.view(), words_.view(), contacts.built_position.span(),
                             contacts.built_velocity.span()},
        "restart the strayed");
    reader_.take(scene.backend, words_.span());
    const std::vector<uint32_t>& words = reader_.wait();
    if (words[kStrayedCount] > kMostStrayed || words[kEntriesLacking] > kMostInserted) return {};
    if (words[kEntriesLacking] > 0) scene.lists.insert(lacking_.view().part(0, words[kEntriesLacking]));
    return {true, secondsOf(words[kMustDecide])};
}

}  // namespace demolish
