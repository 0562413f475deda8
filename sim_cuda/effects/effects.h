// SPDX-License-Identifier: Apache-2.0
// Grit, dust and crumbs of one scene: born where bodies break, moved, written for drawing. It reads the
// bodies and never writes them.
//
//   advance():  all that flies is moved; then what has opened, become single or hit something
//               -> how much each throws off -> sums: birth numbers -> born into the rings
//   write():    the rings as they are drawn
//
// Everything follows from birth numbers, so that it has the same bits on every device; no count is read back.
#pragma once
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "sim_cuda/effects/effect_state.h"
#include "sim_cuda/effects/hard_hits.h"
#include "sim_cuda/effects/move_effects.h"
#include "sim_cuda/effects/new_faces.h"
#include "sim_cuda/effects/single_cells.h"
#include "sim_cuda/effects/write_effects.h"

namespace demolish {

/// The bodies at the end of a frame, clustered: only to read.
template <class Real>
struct FinishedFrame {
    StateIn<Real> state;
    FragmentRows rows;
    Span<const uint32_t> fragment, owner;  ///< per particle
    Span<const uint32_t> slot_of_bond;
    Span<const BondLink> link;
    Span<const ParticleConstants<Real>> constants;
    ParticleCounts counts;
};

/// s after the last birth from which on nothing moves any more.
inline constexpr double kLongestMotion = kLongestFlight + kLongestWait;
static_assert(kLongestFlight > 1.5f * kPuffLife);

template <class Backend, class Real>
class Effects {
  public:
    using Frame = FinishedFrame<Real>;

    /// Keeps a reference to the backend and to the set-up. Off until set() says otherwise. `mesh_steps`: of
    /// the set-up's colliders, on the device.
    Effects(Backend& backend, const SceneSetup& setup, Span<const float> mesh_steps)
        : backend_(backend), setup_(setup), mesh_steps_(mesh_steps) {}

    /// `now`: the bodies at this moment; what is open already throws nothing off. Waits.
    void set(const EffectsSettings& settings, const Frame& now);
    bool on() const { return settings_.on; }
    /// A frame of so many seconds is over. `broke`: bonds; `moved`: anything.
    void advance(const Frame& frame, double elapsed, bool broke, bool moved);
    bool shown() const { return on() && since_birth_ >= 0 && hasBirths(); }
    bool moving() const { return shown() && since_birth_ < kLongestMotion; }

    /// Into streams that are not empty; single cells' transforms, which are written, are made smaller.
    void write(const Frame& frame, const RenderStreams& streams);
    /// As Solver::effectsHash(). Waits.
    uint64_t hash();

    /// What changes from frame to frame, for snapshots. Waits.
    EffectState saveState();
    /// Where it is of a run without effects, what is open throws nothing off. Throws std::out_of_range when
    /// it is of another scene.
    void restoreState(const EffectState& state, const Frame& now);

  private:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    void makeRoom();
    void forget(const Frame& now);
    void throwOff(const Frame& frame, const SourceCounts& sources);
    void keepVelocities(const Frame& frame);
    void move(const Frame& frame, double elapsed);
    BodiesNow<Real> bodiesOf(const Frame& frame) const {
        return {frame.state, frame.fragment, frame.owner, law_.view(), sizes()};
    }
    SizeTables sizes() const { return {grit_size_.view(), crumb_size_.view(), rest_size_.view()}; }
    HitsNow<Real> hitsOf(const Frame& frame) const {
        return {bodiesOf(frame), former_.view(),         frame.constants,
                surroundings(),  frame.counts.in_bodies, static_cast<float>(elapsed_)};
    }
    Births births(const SourceCounts& sources, uint32_t first) {
        return {{grains_.span()},   {puffs_.span()},
                births_.view(),     sums_.view().part(0, 2 * size_t{sources.all()} + 1),
                sources.all(),      first,
                setup_.params.seed, static_cast<float>(elapsed_)};
    }
    Surroundings surroundings() const {
        const Double3& g = setup_.params.gravity;
        return {{float(g.x), float(g.y), float(g.z)},
                makeColliderSet<float>(setup_.params.colliders, mesh_steps_)};
    }
    /// A GPU is not asked.
    bool hasBirths() const {
        if constexpr (Backend::kOnGpu)
            return true;
        else
            return births_.view()[kGrainBirths] + births_.view()[kPuffBirths] > 0;
    }
    /// Slots that may hold something. A GPU is not asked: it goes through all of them.
    uint32_t inUse(const auto& ring, uint32_t kind) const {
        const auto room = static_cast<uint32_t>(ring.size());
        if constexpr (Backend::kOnGpu)
            return room;
        else
            return std::min(room, births_.view()[kind]);
    }

    Backend& backend_;
    const SceneSetup& setup_;
    Span<const float> mesh_steps_;
    EffectsSettings settings_;
    double since_birth_ = -1;  ///< s since something may have been born; negative: nothing has been
    double elapsed_ = 0;       ///< s, of the frame
    uint32_t frames_ = 0;      ///< since they were switched on
    // made when first switched on
    Buffer<Grain> grains_;
    Buffer<Puff> puffs_;
    Buffer<uint32_t> births_;
    Buffer<BondFace> face_;
    Buffer<DrawnCell> cell_;
    Buffer<uint8_t> opened_, crumbled_;  ///< per bond, per particle
    Buffer<uint32_t> sums_;  ///< of each source of a frame: its grains, then its puffs; counts at first
    Buffer<FormerVelocity> former_;  ///< per particle and projectile
    Buffer<DebrisLaw> law_;
    Buffer<float> grit_size_, crumb_size_, rest_size_;
    Buffer<uint64_t> hash_sum_;
};

template <class Backend, class Real>
void Effects<Backend, Real>::set(const EffectsSettings& settings, const Frame& now) {
    const bool was_on = on();
    settings_ = settings;
    settings_.grains = setup_.params.effects.grains;
    settings_.puffs = setup_.params.effects.puffs;
    if (!on()) return;
    if (face_.size() == 0 && births_.size() == 0) makeRoom();
    const auto laws = debrisLaws(setup_.bodies, settings_);
    const auto grit = sizeQuantiles(settings_.finest, kCoarsestGrain, kSizeExponent);
    law_ = backend_.uploaded(laws);
    grit_size_ = backend_.uploaded(grit);
    backend_.synchronize();  // the host copies go out of scope
    if (!was_on) forget(now);
}

template <class Backend, class Real>
void Effects<Backend, Real>::makeRoom() {
    const auto faces = bondFaces(setup_.bodies);
    const auto cells = drawnCells(setup_.bodies);
    const auto crumbs = sizeQuantiles(kLeastCrumb, kMostCrumb, kSizeExponent);
    const auto rest = sizeQuantiles(kLeastRest, 1, kSizeExponent);
    grains_ = backend_.template allocate<Grain>(settings_.grains);
    puffs_ = backend_.template allocate<Puff>(settings_.puffs);
    births_ = backend_.template allocate<uint32_t>(kBirthWords);
    hash_sum_ = backend_.template allocate<uint64_t>(1);
    opened_ = backend_.template allocate<uint8_t>(faces.size());
    crumbled_ = backend_.template allocate<uint8_t>(cells.size());
    const size_t particles = cells.size() + kMaxProjectiles;
    const size_t sources = faces.size() + cells.size() + particles;
    former_ = backend_.template allocate<FormerVelocity>(particles);
    sums_ = backend_.template allocate<uint32_t>(2 * sources + 1);
    face_ = backend_.uploaded(faces);
    cell_ = backend_.uploaded(cells);
    crumb_size_ = backend_.uploaded(crumbs);
    rest_size_ = backend_.uploaded(rest);
    backend_.synchronize();  // the host copies go out of scope
}

template <class Backend, class Real>
void Effects<Backend, Real>::forget(const Frame& now) {
    since_birth_ = -1;
    frames_ = 0;
    backend_.fill(births_.span(), 0u);
    backend_.fill(grains_.span(), Grain{});
    backend_.fill(puffs_.span(), Puff{});
    backend_.forEach(face_.size(),
                     MarkOpenFaces{face_.view(), now.slot_of_bond, now.link, now.fragment, opened_.span()},
                     "mark open faces");
    backend_.forEach(cell_.size(), MarkSingleCells{now.rows, now.owner, law_.view(), crumbled_.span()},
                     "mark single cells");
    keepVelocities(now);
}

template <class Backend, class Real>
void Effects<Backend, Real>::advance(const Frame& frame, double elapsed, bool broke, bool moved) {
    if (!on()) return;
    elapsed_ = elapsed;
    ++frames_;
    if (since_birth_ >= 0) since_birth_ += elapsed;
    if (moving()) move(frame, elapsed);
    throwOff(frame, {broke ? static_cast<uint32_t>(face_.size()) : 0,
                     broke && settings_.crumbling ? static_cast<uint32_t>(cell_.size()) : 0,
                     moved ? static_cast<uint32_t>(former_.size()) : 0});
    if (moved) keepVelocities(frame);
    if (broke || moved) since_birth_ = 0;
}

template <class Backend, class Real>
void Effects<Backend, Real>::throwOff(const Frame& frame, const SourceCounts& sources) {
    const uint32_t all = sources.all();
    if (all == 0) return;
    const uint64_t seed = setup_.params.seed;
    const auto grains = [&](uint32_t first, uint32_t n) { return sums_.span().part(first, n); };
    const auto puffs = [&](uint32_t first, uint32_t n) { return sums_.span().part(all + first, n); };
    const uint32_t cell = sources.firstCell(), hit = sources.firstHit();
    backend_.forEach(
        sources.faces,
        CountOfFaces<Real>{bodiesOf(frame), face_.view(), frame.slot_of_bond, frame.link, opened_.span(),
                           grains(0, sources.faces), puffs(0, sources.faces), seed},
        "count debris of faces");
    backend_.forEach(sources.cells,
                     CountOfCells<Real>{bodiesOf(frame), frame.rows, crumbled_.span(),
                                        grains(cell, sources.cells), puffs(cell, sources.cells), seed},
                     "count crumbs");
    const HitsNow<Real> hits = hitsOf(frame);
    backend_.forEach(
        sources.hits,
        CountOfHits<Real>{hits, grains(hit, sources.hits), puffs(hit, sources.hits), seed, frames_},
        "count debris of hits");
    backend_.exclusiveScan(sums_.view().part(0, 2 * size_t{all}), sums_.span());
    backend_.forEach(sources.faces, ThrowOffFaces<Real>{bodiesOf(frame), face_.view(), births(sources, 0)},
                     "throw off debris of faces");
    backend_.forEach(sources.cells, ThrowOffCells<Real>{bodiesOf(frame), births(sources, cell)},
                     "throw off crumbs");
    backend_.forEach(sources.hits, ThrowOffHits<Real>{hits, births(sources, hit)},
                     "throw off debris of hits");
    backend_.forEach(1, CountBirths{births(sources, 0), births_.span()}, "count births");
}

template <class Backend, class Real>
void Effects<Backend, Real>::keepVelocities(const Frame& frame) {
    backend_.forEach(former_.size(), KeepVelocities<Real>{bodiesOf(frame), frame.constants, former_.span()},
                     "keep velocities");
}

template <class Backend, class Real>
void Effects<Backend, Real>::move(const Frame& frame, double elapsed) {
    const double steps = std::max(1.0, std::ceil(elapsed / kGrainStep - 1e-9));
    const auto dt = static_cast<float>(elapsed / steps);
    backend_.forEach(inUse(grains_, kGrainBirths),
                     MoveGrains{grains_.span(), surroundings(), static_cast<uint32_t>(steps), dt},
                     "move grains");
    backend_.forEach(
        inUse(puffs_, kPuffBirths),
        MovePuffs<Real>{bodiesOf(frame), puffs_.span(), surroundings(), static_cast<uint32_t>(steps), dt},
        "move puffs");
}

template <class Backend, class Real>
void Effects<Backend, Real>::write(const Frame& frame, const RenderStreams& streams) {
    if (!on()) return;
    const auto span = [](const auto& stream) { return Span(stream.data, stream.data ? stream.capacity : 0); };
    if (settings_.crumbling && streams.transforms.data != nullptr)
        backend_.forEach(
            cell_.size(),
            ShrinkSingleCells{frame.rows, frame.owner, law_.view(), cell_.view(), sizes(),
                              surroundings().colliders, setup_.params.seed, span(streams.transforms)},
            "shrink single cells");
    if (!shown() || streams.effect_commands.data == nullptr) return;
    const Span<GrainInstance> grains = span(streams.grains);
    const Span<PuffInstance> puffs = span(streams.puffs);
    backend_.forEach(inUse(grains_, kGrainBirths),
                     WriteInstances<Grain, GrainInstance>{grains_.view(), grains}, "write grains");
    backend_.forEach(inUse(puffs_, kPuffBirths), WriteInstances<Puff, PuffInstance>{puffs_.view(), puffs},
                     "write puffs");
    backend_.forEach(
        1,
        WriteEffectCommands{births_.view(), static_cast<uint32_t>(std::min(grains_.size(), grains.size())),
                            static_cast<uint32_t>(std::min(puffs_.size(), puffs.size())),
                            span(streams.effect_commands)},
        "write effect commands");
}

template <class Backend, class Real>
uint64_t Effects<Backend, Real>::hash() {
    if (!shown()) return 0;
    backend_.fill(hash_sum_.span(), uint64_t{0});
    backend_.forEach(grains_.size(), HashInstances<Grain>{grains_.view(), 1, hash_sum_.span()},
                     "hash grains");
    backend_.forEach(puffs_.size(), HashInstances<Puff>{puffs_.view(), 2, hash_sum_.span()}, "hash puffs");
    uint64_t hash = 0;
    backend_.download(hash_sum_.view(), &hash);
    return hash;
}

template <class Backend, class Real>
EffectState Effects<Backend, Real>::saveState() {
    EffectState state;
    if (!on()) return state;
    state.since_birth = since_birth_;
    state.frames = frames_;
    state.former = backend_.downloaded(former_.view());
    state.births = backend_.downloaded(births_.view());
    const auto used = [&](size_t room, uint32_t kind) { return std::min<size_t>(room, state.births[kind]); };
    state.grains = backend_.downloaded(grains_.view().part(0, used(grains_.size(), kGrainBirths)));
    state.puffs = backend_.downloaded(puffs_.view().part(0, used(puffs_.size(), kPuffBirths)));
    state.opened = backend_.downloaded(opened_.view());
    state.crumbled = backend_.downloaded(crumbled_.view());
    return state;
}

template <class Backend, class Real>
void Effects<Backend, Real>::restoreState(const EffectState& state, const Frame& now) {
    if (!on()) return;
    forget(now);
    if (state.births.empty()) return;
    if (state.grains.size() > grains_.size() || state.puffs.size() > puffs_.size() ||
        state.births.size() != kBirthWords || state.opened.size() != opened_.size() ||
        state.crumbled.size() != crumbled_.size() || state.former.size() != former_.size())
        throw std::out_of_range("effects of another scene");
    since_birth_ = state.since_birth;
    frames_ = state.frames;
    const auto put = [&](auto& buffer, const auto& values) {
        backend_.upload(buffer.span(), values.data(), values.size());
    };
    put(births_, state.births);
    put(grains_, state.grains);
    put(puffs_, state.puffs);
    put(opened_, state.opened);
    put(crumbled_, state.crumbled);
    put(former_, state.former);
    backend_.synchronize();  // the host copies go out of scope
}

}  // namespace demolish
