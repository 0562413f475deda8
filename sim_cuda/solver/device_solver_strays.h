// SPDX-License-Identifier: Apache-2.0
// Particles that have left the paths of the contact lists get new ones; the lists stay, as long as they can.
// Part of device_solver.h.
#pragma once
#include <algorithm>
#include <cmath>

#include "sim_cuda/kernels/strayed_paths.h"
#include "sim_cuda/solver/device_solver.h"

namespace demolish {

/// At the end of a stretch, with lists that hold for another: `next` substeps. Waits.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::followStrayed(uint32_t next) {
    placeRigid();
    lists_stand_ = false;
    const double elapsed = progress_.since_build * tables_.time_step, stretch = next * tables_.time_step;
    auto& contacts = lists_.contacts();
    const PathsNow<Real> paths{data_.particles.in(data_.current), contacts.paths(),
                               static_cast<Real>(elapsed), static_cast<Real>(stretch)};
    backend_.forEach(tables_.counts.total, ListStrayed<Real>{paths, strayed_.span(), stray_words_.span()},
                     "list the strayed");
    constexpr uint32_t kThreads = Backend::kOnGpu ? 8 : 1;
    backend_.forEach(
        size_t{tables_.counts.total} * kThreads,
        SeeStrayed<kThreads, Real>{
            paths, data_.bonds.in(), contacts.in(), lists_.buried(), clusters_.fragment(),
            regimes_.on() ? regimes_.regime() : Span<const uint32_t>{}, data_.particles.constants.view(),
            params_.planes, static_cast<Real>(lists_.horizon() - elapsed),
            static_cast<Real>(regimes_.gentlestHit()), tables_.counts.in_bodies, strayed_.view(),
            lacking_.span(), stray_words_.span()},
        "see the strayed");
    backend_.forEach(kMostStrayed,
                     RestartStrayed<Real>{paths, strayed_.view(), stray_words_.view(),
                                          contacts.built_position.span(), contacts.built_velocity.span()},
                     "restart the strayed");
    reader_.take(backend_, stray_words_.span());
    const std::vector<uint32_t>& words = reader_.wait();
    const double decide = secondsOf(words[kMustDecide]);
    if (words[kStrayedCount] > kMostStrayed || words[kEntriesLacking] > kMostInserted) {
        progress_.rebuild = 1;
        return;
    }
    if (words[kEntriesLacking] > 0) lists_.insert(lacking_.view().part(0, words[kEntriesLacking]));
    if (!regimes_.on() || !regimes_.leavesBonds()) return;
    const auto stretches = static_cast<uint64_t>(std::min(decide, 1.0) / stretch);
    if (decide < 1)
        progress_.decide_at = std::min(progress_.decide_at, progress_.substeps + stretches * next);
}

}  // namespace demolish
