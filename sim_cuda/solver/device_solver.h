// SPDX-License-Identifier: Apache-2.0
// The solver on one backend: what a Solver is asked for, handed to the part that does it.
//
//   device_scene.h    what is simulated, on the device
//   projectiles.h     balls: slots, starts            frame_loop.h      the order of the work in a frame
//   frame_books.h     what is reported                energy_measure.h  energies of the moment
//   frame_exporter.h  a frame for drawing             scene_bytes.h     the state as bytes
//   settling.h        before the first frame          effects/effects.h grit and dust, which only watch
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/solver.h"
#include "sim_cuda/effects/effects.h"
#include "sim_cuda/kernels/state_hash.h"
#include "sim_cuda/solver/energy_measure.h"
#include "sim_cuda/solver/frame_books.h"
#include "sim_cuda/solver/frame_exporter.h"
#include "sim_cuda/solver/frame_loop.h"
#include "sim_cuda/solver/scene_bytes.h"
#include "sim_cuda/solver/settling.h"

namespace demolish {

template <class Backend, class Real>
class DeviceSolver final : public Solver {
  public:
    DeviceSolver(const SceneSetup& setup, const ProgressCallback& progress);

    StepStatus advanceFrame(double time_scale, const FrameWatch& watch) override;
    StepStatus advanceSubsteps(uint32_t n) override {
        giveUpFrame();
        return advance(n, {});
    }
    bool frameUnfinished() const override { return loop_.frameUnfinished(); }
    void giveUpFrame() override { loop_.giveUpFrame(); }
    double fire(const Projectile& projectile) override;
    void exportFrame(const RenderStreams& streams, bool streams_fresh) override {
        exporter_.write(scene_, projectiles_, stats().bonds_broken, streams, streams_fresh);
        effects_.write(finishedFrame(), streams);
        scene_.backend.synchronize();
    }
    StreamSizes exportSizes() const override { return streamSizes(scene_.setup); }
    const FrameStats& stats() const override { return books_.stats(); }
    void measure() override;
    void bookEnergy(bool on) override;
    bool booksEnergy() const override { return scene_.setup.params.ledger; }
    void setEffects(const EffectsSettings& settings) override;
    uint64_t effectsHash() const override { return effects_.hash(); }
    uint64_t stateHash() const override;
    Snapshot save() const override;
    void restore(const Snapshot& snapshot) override;
    const SofteningReport& softening() const override { return scene_.tables.body[0].report; }
    std::string deviceName() const override { return scene_.backend.deviceName(); }
    bool onGpu() const override { return Backend::kOnGpu; }
    void synchronize() override { scene_.backend.synchronize(); }
    void* workStream() const override { return scene_.backend.stream(); }

  private:
    StepStatus advance(uint32_t n, const FrameWatch& watch);
    FinishedFrame<Real> finishedFrame() const;
    void tellOfEffects() { books_.setEffects(effects_.shown(), effects_.moving()); }
    void sumFrame();
    void clearLedger() { scene_.backend.fill(scene_.data.ledger.span(), Vec4<Real>{}); }
    void readState(ByteStream& in);

    // What reads the state uses the backend and its own memory, and changes nothing that is simulated.
    mutable DeviceScene<Backend, Real> scene_;
    Projectiles projectiles_;
    FrameLoop<Backend, Real> loop_;
    FrameBooks books_;
    EnergyMeasure<Backend, Real> energy_;
    mutable FrameExporter<Backend, Real> exporter_;
    mutable Effects<Backend, Real> effects_;
    mutable typename Backend::template Buffer<uint64_t> hash_sum_;
};

template <class Backend, class Real>
DeviceSolver<Backend, Real>::DeviceSolver(const SceneSetup& setup, const ProgressCallback& progress)
    : scene_(setup, progress),
      projectiles_(setup.projectiles, setup.params.gravity, scene_.tables.time_step),
      loop_(scene_, projectiles_),
      books_(scene_.tables.time_step, scene_.tables.mass_in_bodies, scene_.tables.counts.in_bodies,
             scene_.data.bonds.count),
      exporter_(scene_.backend, setup, scene_.tables),
      effects_(scene_.backend, scene_.setup, scene_.mesh_steps.view()),
      hash_sum_(scene_.backend.template allocate<uint64_t>(1)) {
    const bool settles = setup.params.settle_time > 0;
    loop_.stepper().recordAhead(scene_);
    if (settles) settle(scene_, loop_, progress);
    loop_.startProjectiles();
    projectiles_.begin();
    scene_.fragments.recluster(scene_.data);
    scene_.fragments.advanceAges();
    scene_.fragments.gather(scene_.data);
    books_.setFragments(scene_.fragments.summary());
    if (settles || scene_.release.on()) scene_.regimes.markRested();
    setEffects(setup.params.effects);
}

template <class Backend, class Real>
FinishedFrame<Real> DeviceSolver<Backend, Real>::finishedFrame() const {
    const auto& clusters = scene_.fragments.drawn().clusters;
    const auto& data = scene_.data;
    return {scene_.state(),
            clusters.rows(),
            clusters.fragment(),
            data.particles.owner.view(),
            data.bonds.slot_of_bond.view(),
            data.bonds.link.view(),
            data.particles.constants.view(),
            scene_.tables.counts};
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::setEffects(const EffectsSettings& settings) {
    effects_.set(settings, finishedFrame());
    tellOfEffects();
}

template <class Backend, class Real>
StepStatus DeviceSolver<Backend, Real>::advanceFrame(double time_scale, const FrameWatch& watch) {
    if (!(time_scale > 0 && time_scale <= 1))
        throw UsageError("Slow motion must lie above 0 and at most at 1.");
    return advance(slowedSubsteps(scene_.tables.substeps, time_scale), watch);
}

template <class Backend, class Real>
StepStatus DeviceSolver<Backend, Real>::advance(uint32_t n, const FrameWatch& watch) {
    const auto frame = loop_.advance(n, watch);
    books_.setStatus(frame.status);
    if (frame.substeps == 0) return frame.status;
    books_.setAwake(scene_.regimes);
    books_.closeFrame(frame.substeps, scene_.time(), frame.list_rebuilds);
    if (frame.quiet)
        scene_.fragments.advanceAges();
    else
        sumFrame();
    effects_.advance(finishedFrame(), frame.substeps * scene_.tables.time_step, stats().fracture_changed,
                     !frame.quiet);
    tellOfEffects();
    return frame.status;
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::sumFrame() {
    constexpr uint32_t kThreads = Backend::kOnGpu ? 4 : 1;
    const bool booked = booksEnergy();
    const FrameSums sums =
        scene_.backend.reduce(size_t{scene_.tables.counts.total} * kThreads, FrameSums{},
                              SumFrame<kThreads, Real>{scene_.arrays(), scene_.tables.counts.in_bodies},
                              SumInto<FrameSums>{}, "sum the frame");
    if (booked) clearLedger();
    books_.addSums(sums, booked, projectiles_.work());
    const bool changed = stats().fracture_changed;
    if (changed) scene_.fragments.recluster(scene_.data);
    scene_.fragments.advanceAges();
    scene_.fragments.gather(scene_.data);
    if (changed) books_.setFragments(scene_.fragments.summary());
}

template <class Backend, class Real>
double DeviceSolver<Backend, Real>::fire(const Projectile& projectile) {
    checkStart(projectile, scene_.setup.params.colliders);
    projectiles_.fire(projectile, scene_.substeps);
    scene_.uploadLaws(projectiles_.all());
    loop_.startProjectiles();
    const Double3 wanted = projectile.position, placed = projectiles_.all().back().position;
    return length(Vec3<double>{placed.x - wanted.x, placed.y - wanted.y, placed.z - wanted.z});
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::measure() {
    const uint32_t undecided = loop_.undecidedFrame();
    if (undecided > 0) loop_.beginFrame(undecided);
    loop_.withGoodLists([&] {
        books_.setMechanical(energy_.measure(scene_, loop_.stepper(), undecided > 0), projectiles_.work());
    });
    if (undecided > 0) loop_.giveUpFrame();
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::bookEnergy(bool on) {
    if (on == booksEnergy()) return;
    scene_.setup.params.ledger = on;
    scene_.regimes.keepBooks(on);
    clearLedger();
    loop_.stepper().recordAhead(scene_);
}

template <class Backend, class Real>
uint64_t DeviceSolver<Backend, Real>::stateHash() const {
    scene_.backend.fill(hash_sum_.span(), uint64_t{0});
    scene_.backend.forEach(
        scene_.tables.counts.total,
        HashParticle<Real>{scene_.state(), scene_.data.bonds.in(), scene_.lists.contacts().in(),
                           scene_.data.collider_spring.view(), scene_.params.colliders.count,
                           scene_.tables.counts.total, hash_sum_.span()},
        "hash the state");
    uint64_t hash = 0;
    scene_.backend.download(hash_sum_.view(), &hash);
    return hash;
}

template <class Backend, class Real>
Snapshot DeviceSolver<Backend, Real>::save() const {
    ByteStream out;
    out.writeValue(scene_.tables.counts);
    out.writeValue(loop_.state());
    out.writeValue(books_.state());
    out.writeVector(projectiles_.all());
    writeScene(out, scene_);
    exporter_.save(out);
    effects_.saveState().write(out);
    return {out.take()};
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::restore(const Snapshot& snapshot) {
    giveUpFrame();
    try {
        ByteStream in(snapshot.bytes);
        readState(in);
    } catch (const std::out_of_range& problem) {
        throw UsageError(std::string("The state cannot be restored: ") + problem.what() + ".");
    }
    scene_.uploadLaws(projectiles_.all());
    clearLedger();  // a run without books leaves it as it was
    scene_.fragments.gather(scene_.data);
    books_.setFragments(scene_.fragments.summary());
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::readState(ByteStream& in) {
    const auto counts = in.readValue<ParticleCounts>();
    if (counts.total != scene_.tables.counts.total) throw std::out_of_range("snapshot of another scene");
    auto loop = in.readValue<LoopState>();
    const auto books = in.readValue<FrameBooks::State>();
    const auto projectiles = in.readVector<Projectile>();
    readScene(in, scene_);
    const auto saved = exporter_.read(in);
    const auto effects = EffectState::read(in);
    if (!in.atEnd()) throw std::out_of_range("snapshot of another scene");
    loop.quiet = 0;  // regimes have to be decided once more
    projectiles_.resume(projectiles, loop.projectiles);
    loop_.resume(loop);
    books_.resume(books, projectiles_.work(), scene_.time());
    scene_.fragments.recluster(scene_.data);
    exporter_.restore(scene_, saved);
    effects_.restoreState(effects, finishedFrame());
    tellOfEffects();
}

}  // namespace demolish
