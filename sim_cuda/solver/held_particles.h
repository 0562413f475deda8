// SPDX-License-Identifier: Apache-2.0
// What a scene's anchors hold, and how their paths lead it (kernels/lead_held.h). A scene without anchors has
// nothing of it.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "sim_cuda/kernels/lead_held.h"
#include "sim_cuda/solver/motion_path.h"
#include "sim_cuda/solver/solver_data.h"

namespace demolish {

template <class Backend, class Real>
class HeldParticles {
  public:
    /// Keeps a reference to the backend.
    HeldParticles(Backend& backend, const SceneSetup& setup, const SceneTables& tables);

    /// False: nothing is held, and nothing below is to be called.
    bool on() const { return on_; }
    /// Does any path lead anywhere between these times (s)?
    bool leads(double from, double to) const { return ledBetween(from, to) != 0; }
    /// Of the present fragments, in the time from `from` to `to` (s). Does not wait.
    void mark(Span<const uint32_t> label, double from, double to);
    HoldsIn holds() const { return on() ? HoldsIn{leader_.view(), flags_.view()} : HoldsIn{}; }
    /// Sets the velocities of what paths lead, for `ahead` s from `now` (s) on: particles in both instants of
    /// the state, which must be complete. Remembers what they were (SubstepArrays::led_from). Does not wait.
    void lead(SolverData<Backend, Real>& data, double now, double ahead);
    /// A step has been taken, or an earlier state has been put back.
    void forgetFormer(SolverData<Backend, Real>& data) {
        if (std::exchange(remembers_, false)) backend_.fill(data.led_from.span(), Vec4<Real>{});
    }

  private:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    uint32_t ledBetween(double from, double to) const;
    void gatherPaths(const SceneSetup& setup, const SceneTables& tables);

    Backend& backend_;
    bool on_, remembers_ = false;
    std::vector<MotionPath> paths_;
    std::vector<Vec3<double>> pivots_;  ///< of the paths, at the start
    Buffer<uint32_t> path_, leader_, flags_;
    Buffer<LedParticle> particle_;
};

template <class Backend, class Real>
HeldParticles<Backend, Real>::HeldParticles(Backend& backend, const SceneSetup& setup,
                                            const SceneTables& tables)
    : backend_(backend), on_(!tables.anchor.empty()) {
    if (on()) gatherPaths(setup, tables);
}

template <class Backend, class Real>
void HeldParticles<Backend, Real>::gatherPaths(const SceneSetup& setup, const SceneTables& tables) {
    std::vector<uint32_t> path_of_anchor;
    for (const Anchor& anchor : setup.anchors) {
        path_of_anchor.push_back(anchor.path.keys.empty() ? kStands : static_cast<uint32_t>(paths_.size()));
        if (anchor.path.keys.empty()) continue;
        paths_.push_back(anchor.path);
        pivots_.push_back({anchor.pivot.x, anchor.pivot.y, anchor.pivot.z});
    }
    std::vector<uint32_t> path(tables.anchor.size(), kFree);
    std::vector<LedParticle> led;
    for (uint32_t i = 0; i < path.size(); ++i) {
        if (tables.anchor[i] == SceneTables::kNoAnchor) continue;
        path[i] = path_of_anchor[tables.anchor[i]];
        if (path[i] != kStands)
            led.push_back({i, path[i], tables.position[i] - pivots_[path[i]], tables.rotation[i]});
    }
    path_ = backend_.uploaded(path);
    if (!led.empty()) particle_ = backend_.uploaded(led);
    leader_ = backend_.template allocate<uint32_t>(tables.counts.total);
    flags_ = backend_.template allocate<uint32_t>(tables.counts.total);
    backend_.synchronize();  // the host copies go out of scope
}

template <class Backend, class Real>
uint32_t HeldParticles<Backend, Real>::ledBetween(double from, double to) const {
    uint32_t led = 0;
    for (uint32_t p = 0; p < paths_.size(); ++p)
        if (movesBetween(paths_[p], from, to)) led |= 1u << p;
    return led;
}

template <class Backend, class Real>
void HeldParticles<Backend, Real>::mark(Span<const uint32_t> label, double from, double to) {
    const size_t total = leader_.size(), in_bodies = path_.size();
    backend_.forEach(total, StartHolds{leader_.span(), flags_.span()}, "start holds");
    backend_.forEach(in_bodies, FindLeaders{label, path_.view(), leader_.span()}, "find leaders");
    backend_.forEach(in_bodies,
                     FlagHolds{label, path_.view(), leader_.view(), flags_.span(), ledBetween(from, to)},
                     "flag holds");
}

template <class Backend, class Real>
void HeldParticles<Backend, Real>::lead(SolverData<Backend, Real>& data, double now, double ahead) {
    remembers_ = true;
    LeadHeld<Real> lead{particle_.view(),
                        {},
                        ledBetween(now, now + ahead),
                        ahead,
                        data.particles.in(data.current),
                        data.particles.out(data.current),
                        data.particles.out(1 - data.current),
                        data.led_from.span()};
    for (uint32_t p = 0; p < paths_.size(); ++p) {
        const PathPose is = poseAt(paths_[p], now), then = poseAt(paths_[p], now + ahead);
        lead.path[p] = {pivots_[p] + then.way, is.turned, then.turned,
                        (1 / ahead) * turnBetween(is.turned, then.turned)};
    }
    backend_.forEach(particle_.size(), lead, "lead what is held");
}

}  // namespace demolish
