// SPDX-License-Identifier: Apache-2.0
// Bodies that come apart into preset pieces: foresees who is hit, and breaks the bonds between the pieces.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <vector>

#include "sim_cuda/api/solver.h"
#include "sim_cuda/patterns/fit_pattern.h"
#include "sim_cuda/patterns/release_pieces.h"
#include "sim_cuda/physics/random.h"

namespace demolish {

/// Owns the patterns and who has come apart. Without SolverParams::preset_pieces it is off, and empty.
template <class Backend, class Real>
class PieceRelease {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Keeps a reference to the backend. owners: bodies and projectile slots.
    PieceRelease(Backend& backend, const SceneSetup& setup, uint32_t owners);

    bool on() const { return on_; }

    struct Foreseen {
        bool splits = false;  ///< some bodies come apart now: release() is due
        double next = 1e30;   ///< s until the next one is hit, if it is before the next decision
    };
    /// Who is hit within `within` s comes apart now. Waits.
    Foreseen foresee(const HardTouches<Real>& touches, double within);
    /// After foresee(): breaks the bonds between pieces.
    void release(const HardTouches<Real>& touches, Span<const uint32_t> row_start, Span<BondLink> link);

    /// Per body: 1 of those that came apart in the last foresee().
    Span<const uint32_t> splits() const { return splits_.view(); }
    Span<const WakeLaw<Real>> laws() const { return law_.view(); }

    /// Calls visit(buffer) for what a checkpoint has to keep.
    template <class Visit>
    void visitBuffers(const Visit& visit) {
        visit(released_);
    }

  private:
    void uploadPatterns(const SceneSetup& setup, const PresetPieces& preset);

    Backend& backend_;
    bool on_, at_impact_;
    uint32_t bodies_, particles_ = 0;
    Buffer<WakeLaw<Real>> law_;
    Buffer<PiecePattern> pattern_;
    Buffer<PatternFrame> frame_;
    Buffer<Vec4<float>> rest_;
    Buffer<uint32_t> piece_, released_, splits_, first_, struck_, words_;
    typename Backend::Reader reader_;
};

template <class Backend, class Real>
PieceRelease<Backend, Real>::PieceRelease(Backend& backend, const SceneSetup& setup, uint32_t owners)
    : backend_(backend),
      on_(setup.params.preset_pieces.has_value()),
      at_impact_(on_ && setup.params.preset_pieces->at_impact),
      bodies_(static_cast<uint32_t>(setup.bodies.size())),
      reader_(backend) {
    if (!on_) return;
    std::vector<WakeLaw<Real>> laws(owners, {Real(1e30), Real(1e30), Real(1e30)});
    for (uint32_t b = 0; b < bodies_; ++b) {
        const BodyInstance& body = setup.bodies[b];
        const WakeLaw<double> law =
            releaseLaw(body.material.beta, body.material.critical_velocity, body.threshold_share,
                       static_cast<double>(body.body->particles.size()));
        laws[b] = {static_cast<Real>(law.heavy), static_cast<Real>(law.light), static_cast<Real>(law.body)};
    }
    law_ = backend.uploaded(laws);
    for (Buffer<uint32_t>* words : {&released_, &splits_, &first_, &struck_})
        *words = backend.template allocate<uint32_t>(bodies_);
    words_ = backend.template allocate<uint32_t>(kPresetWords);
    uploadPatterns(setup, *setup.params.preset_pieces);
    backend.synchronize();  // the host copies go out of scope
}

/// How the pattern of a body lies until something turns it: upright; one that an impact will turn is fitted
/// as if that came from the side.
inline PatternFrame frameAtRest(const BreakableBody& body, bool at_impact) {
    const Double3 &low = body.bounds_min, &high = body.bounds_max;
    const auto middle = [](double a, double b) { return static_cast<float>((a + b) / 2); };
    const Vec3<float> centre{middle(low.x, high.x), middle(low.y, high.y), middle(low.z, high.z)};
    if (!at_impact) return patternFrame(centre, {0, 1, 0});
    return patternFrame({static_cast<float>(low.x), centre.y, centre.z}, {1, 0, 0});
}

template <class Backend, class Real>
void PieceRelease<Backend, Real>::uploadPatterns(const SceneSetup& setup, const PresetPieces& preset) {
    std::vector<PiecePattern> pattern;
    std::vector<PatternFrame> frame;
    std::vector<Vec4<float>> rest;
    for (uint32_t b = 0; b < bodies_; ++b) {
        const BreakableBody& body = *setup.bodies[b].body;
        const uint32_t pieces = std::max(1u, setup.bodies[b].material.tough_cells);
        double volume = 0;
        const size_t first = rest.size();
        for (const Particle& p : body.particles) {
            volume += p.volume;
            rest.push_back({float(p.seed.x), float(p.seed.y), float(p.seed.z), 0.0f});
        }
        frame.push_back(frameAtRest(body, preset.at_impact));
        const PiecePattern guess{preset.pattern, static_cast<float>(std::cbrt(volume / pieces)),
                                 static_cast<uint32_t>(counterHash(setup.params.seed, b))};
        pattern.push_back(fittedPattern(guess, frame.back(), std::span(rest).subspan(first), pieces));
    }
    pattern_ = backend_.uploaded(pattern);
    frame_ = backend_.uploaded(frame);
    rest_ = backend_.uploaded(rest);
    particles_ = static_cast<uint32_t>(rest.size());
    piece_ = backend_.template allocate<uint32_t>(particles_);
    backend_.synchronize();  // the host copies go out of scope
}

template <class Backend, class Real>
typename PieceRelease<Backend, Real>::Foreseen PieceRelease<Backend, Real>::foresee(
    const HardTouches<Real>& touches, double within) {
    backend_.fill(first_.span(), kNoTouch);
    backend_.fill(words_.span().part(kSplitsNow, 1), 0u);
    backend_.fill(words_.span().part(kNextTouch, 1), kNoTouch);
    backend_.forEach(particles_, ForeseeTouches<Real>{touches, released_.view(), first_.span()},
                     "foresee touches");
    backend_.forEach(bodies_,
                     ChooseSplits{first_.view(), wordOfTime(static_cast<float>(within)), released_.span(),
                                  splits_.span(), words_.span()},
                     "choose what comes apart");
    reader_.start(backend_, words_.view());
    const std::vector<uint32_t>& words = reader_.wait();
    return {words[kSplitsNow] != 0,
            words[kNextTouch] == kNoTouch ? 1e30 : double{std::bit_cast<float>(words[kNextTouch])}};
}

template <class Backend, class Real>
void PieceRelease<Backend, Real>::release(const HardTouches<Real>& touches, Span<const uint32_t> row_start,
                                          Span<BondLink> link) {
    const Span<const uint32_t> owner = touches.rules.meetings.owner;
    if (at_impact_) {
        backend_.fill(struck_.span(), kNoTouch);
        backend_.forEach(particles_, FindStruck<Real>{touches, splits_.view(), first_.view(), struck_.span()},
                         "find what is struck");
        backend_.forEach(
            bodies_, TurnPatterns<Real>{touches, splits_.view(), struck_.view(), rest_.view(), frame_.span()},
            "turn patterns");
    }
    backend_.forEach(
        particles_,
        CutPieces{owner, splits_.view(), pattern_.view(), frame_.view(), rest_.view(), piece_.span()},
        "cut pieces");
    backend_.forEach(particles_, ReleaseBonds{owner, splits_.view(), piece_.view(), row_start, link},
                     "release bonds");
}

}  // namespace demolish
