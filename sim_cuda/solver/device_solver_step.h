// SPDX-License-Identifier: Apache-2.0
// Stepping: chunks of substeps between looks, contact lists, settling. Part of device_solver.h.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/kernels/book_softening.h"
#include "sim_cuda/kernels/in_turn.h"
#include "sim_cuda/kernels/look_at_state.h"
#include "sim_cuda/kernels/strayed_paths.h"
#include "sim_cuda/solver/device_solver.h"

namespace demolish {

/// Gravity is switched on over this share of the settling time; velocities decay at this rate meanwhile
/// (models E.4).
inline constexpr double kSettleRampShare = 0.3, kSettleDamping = 12;

/// Lists are made for so many times the time that they have lasted of late: a longer horizon than is used
/// costs a coarser grid and longer rows. Substeps that they shall last at least: two stretches.
inline constexpr double kHorizonLives = 2;
inline constexpr uint32_t kLeastHorizon = 2 * kRigidStretch.length();

template <class Real>
StepParams<Real> makeStepParams(const SolverParams& from, const SceneTables& tables) {
    StepParams<Real> params;
    params.dt = params.carry_time = static_cast<Real>(tables.time_step);
    params.gravity = toReal<Real>({from.gravity.x, from.gravity.y, from.gravity.z});
    params.stiffness_cap = static_cast<Real>(tables.contact_cap);
    params.hertz = from.contact_law == ContactLaw::kHertz ? 1 : 0;
    params.owners = tables.owners();
    params.in_bodies = tables.counts.in_bodies;
    params.total = tables.counts.total;
    params.planes.count = static_cast<uint32_t>(from.planes.size());
    for (size_t p = 0; p < from.planes.size(); ++p)
        params.planes.planes[p] =
            withW(toReal<Real>({from.planes[p].normal.x, from.planes[p].normal.y, from.planes[p].normal.z}),
                  static_cast<Real>(from.planes[p].offset));
    return params;
}

/// m, body frame, in the solver's order.
template <class Real>
std::vector<Vec4<Real>> restPositions(const std::vector<BodyInstance>& bodies) {
    std::vector<Vec4<Real>> rest;
    for (const BodyInstance& instance : bodies)
        for (const Particle& p : instance.body->particles)
            rest.push_back(withW(toReal<Real>({p.seed.x, p.seed.y, p.seed.z}), Real(0)));
    return rest;
}
inline std::vector<uint32_t> particlesPerBody(const std::vector<BodyInstance>& bodies) {
    std::vector<uint32_t> counts;
    for (const BodyInstance& instance : bodies)
        counts.push_back(static_cast<uint32_t>(instance.body->particles.size()));
    return counts;
}

template <class Backend, class Real>
DeviceSolver<Backend, Real>::DeviceSolver(const SceneSetup& setup, const ProgressCallback& progress)
    : setup_(setup),
      tables_(buildSceneTables(setup, progress)),
      data_(backend_, tables_, static_cast<uint32_t>(setup.params.planes.size())),
      lists_(backend_, tables_.counts, tables_.largest_radius),
      runner_(backend_),
      regimes_(backend_, setup, tables_),
      clusters_(backend_, tables_.counts),
      motion_(backend_, restPositions<Real>(setup.bodies), particlesPerBody(setup.bodies)),
      surface_(backend_, concatenateGeometry(setup.bodies)),
      reader_(backend_),
      look_words_(backend_.template allocate<uint32_t>(kLookWords)),
      stray_words_(backend_.template allocate<uint32_t>(kStrayWords)),
      strayed_(backend_.template allocate<uint32_t>(kMostStrayed)),
      lacking_(backend_.template allocate<uint64_t>(kMostInserted)),
      hash_sum_(backend_.template allocate<uint64_t>(1)),
      shown_projectiles_(backend_.template allocate<Vec4<Real>>(kMaxProjectiles)),
      broken_bonds_(backend_.template allocate<uint8_t>(data_.bonds.count)),
      params_(makeStepParams<Real>(setup.params, tables_)),
      projectiles_(setup.projectiles) {
    data_.uploadLaws(backend_, buildLawTables(setup_, tables_, projectiles_));
    lists_.setBuried(tables_.buried);
    stats_.time_step = tables_.time_step;
    stats_.particles = tables_.counts.in_bodies;
    stats_.bonds = data_.bonds.count;
    stats_.mass = tables_.mass_in_bodies;
    recordAhead();
    if (setup.params.settle_time > 0) settle(setup.params.settle_time, progress);
    progress_.projectiles = static_cast<uint32_t>(projectiles_.size());
    startProjectiles();
    clusters_.update(data_.bonds.row_start.view(), data_.bonds.link.view());
    motion_.advanceAges(clusters_.rows());
    sumFragments();
    countFragments();
    if (setup.params.settle_time > 0) regimes_.markRested();
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::recordAhead() {
    if constexpr (Backend::kOnGpu) {
        const bool ledger = setup_.params.ledger;
        if (std::exchange(recorded_ahead_[ledger ? 1 : 0], true)) return;
        runner_.recordAhead(backend_, stats_.particles, ledger);
        if (regimes_.on())
            rigid_runner_.template recordAhead<decltype(runner_)>(backend_, stats_.particles, ledger);
    }
}

template <class Backend, class Real>
StepStatus DeviceSolver<Backend, Real>::advanceFrame(double time_scale) {
    if (!(time_scale > 0 && time_scale <= 1))
        throw UsageError("Slow motion must lie above 0 and at most at 1.");
    return advance(static_cast<uint32_t>(std::max(1.0, std::round(tables_.substeps * time_scale))));
}

template <class Backend, class Real>
StepStatus DeviceSolver<Backend, Real>::advanceSubsteps(uint32_t n) {
    return advance(n);
}

template <class Backend, class Real>
StepStatus DeviceSolver<Backend, Real>::advance(uint32_t n) {
    if (staysQuiet(n)) return passQuietly(n);
    const Progress before = progress_;
    const uint64_t builds = lists_.builds();
    lists_stand_ = false;
    frame_start_.keep(backend_, data_, lists_, regimes_);
    startProjectiles();
    if (regimes_.on()) {
        if (progress_.rebuild != 0) buildLists();
        assignRegimes(true, n);
    }
    const StepStatus status = runSubsteps(n);
    stats_.status = status;
    if (status != StepStatus::kOk) {
        frame_start_.putBack(backend_, data_, lists_, regimes_);
        place_rigid_ = false;
        progress_ = before;
        regimes_.remember(progress_.regimes);
        return status;
    }
    progress_.last_frame = n;
    stats_.list_rebuilds = static_cast<uint32_t>(lists_.builds() - builds);
    collectFrame(n);
    return status;
}

/// Everything sleeps, and no projectile starts: the frame would change nothing but the time.
template <class Backend, class Real>
bool DeviceSolver<Backend, Real>::staysQuiet(uint32_t n) const {
    const bool due = progress_.rebuild != 0 || progress_.shot_started != 0;
    return progress_.quiet != 0 && !due && nextStart() >= progress_.substeps + n;
}

template <class Backend, class Real>
StepStatus DeviceSolver<Backend, Real>::passQuietly(uint32_t n) {
    progress_.substeps += n;
    progress_.last_frame = n;
    stats_.status = StepStatus::kOk;
    stats_.list_rebuilds = 0;
    stats_.fracture_changed = false;
    tellFrame(n);
    motion_.advanceAges(clusters_.rows());
    return stats_.status;
}

/// Without bonds nothing happens fast.
template <class Backend, class Real>
Stretch DeviceSolver<Backend, Real>::stretch() const {
    if (regimes_.on() && !regimes_.movesBonds()) return kRigidStretch;
    return tables_.time_step < kShortSubstep ? kShortBondedStretch : kBondedStretch;
}

template <class Backend, class Real>
StepStatus DeviceSolver<Backend, Real>::runSubsteps(uint32_t n) {
    bool moved = false;
    while (n > 0) {
        startProjectiles();
        if (progress_.rebuild != 0) {
            buildLists();
            if (mustReassign(n)) assignRegimes(false, n);
        } else if (untilDecision(n) == 0) {
            assignRegimes(false, n);
        }
        if (nothingMoves()) {
            const uint32_t quiet = substepsUntilNextStart(n);
            progress_.substeps += quiet;
            n -= quiet;
            continue;
        }
        moved = true;
        const uint32_t chunk = substepsUntilNextStart(untilDecision(std::min(n, stretch().length())));
        const StepStatus status = runChunk(chunk);
        if (status != StepStatus::kOk) return status;
        n -= chunk;
    }
    progress_.quiet = moved ? 0 : 1;
    if (!moved) return StepStatus::kOk;
    look(0);
    return static_cast<StepStatus>(reader_.wait()[kLookStatus]);
}

/// Contact lists were made anew within a frame: rigid fragments need new lists of what may touch, and what
/// comes near a sleeper wakes it.
template <class Backend, class Real>
bool DeviceSolver<Backend, Real>::mustReassign(uint32_t remaining) {
    if (!regimes_.on() || progress_.last_assigned == progress_.substeps) return false;
    return progress_.shot_started != 0 || regimes_.movesRigid() || untilDecision(1) == 0 ||
           regimes_.stirs(data_, lists_, clusters_, untilNextDecision(remaining));
}

/// At most one stretch; the look in it decides for its end, and has to see as far as the end of the next.
template <class Backend, class Real>
StepStatus DeviceSolver<Backend, Real>::runChunk(uint32_t n) {
    if (progress_.rebuild != 0) buildLists();
    const Stretch whole = stretch();
    const uint32_t first = std::min(n, whole.first), second = n - first, next = whole.length();
    runAwake(first);
    look(second + next);
    runAwake(second);
    const std::vector<uint32_t>& words = reader_.wait();
    const double needed = (progress_.since_build + static_cast<double>(next)) * tables_.time_step;
    const auto status = static_cast<StepStatus>(words[kLookStatus]);
    progress_.left_paths = words[kLookRebuild] != 0 ? 1 : 0;
    if (status == StepStatus::kOk && progress_.left_paths != 0 && needed <= lists_.horizon())
        followStrayed(next);
    else if (progress_.left_paths != 0)
        progress_.rebuild = 1;
    if (needed > lists_.horizon()) progress_.rebuild = 1;
    return status;
}

/// Contact steps move only those particles of a rigid fragment that may touch something; before anybody reads
/// the state, the others follow.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::placeRigid() {
    if (place_rigid_)
        backend_.forEach(tables_.counts.total, regimes_.placer(data_, clusters_), "place rigid");
    place_rigid_ = false;
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::look(uint32_t lookahead) {
    const auto seconds = [&](uint32_t substeps) { return static_cast<Real>(substeps * tables_.time_step); };
    const CheckPaths<Real> paths{data_.particles.in(data_.current), lists_.contacts().paths(),
                                 look_words_.span().part(kLookRebuild, 1), seconds(progress_.since_build),
                                 seconds(lookahead)};
    const LookAtState<Real> look{paths, data_.particles.constants.view(), look_words_.span(),
                                 static_cast<Real>(setup_.params.scene_radius)};
    if (place_rigid_)
        backend_.forEach(tables_.counts.total, InTurn{regimes_.placer(data_, clusters_), look},
                         "place rigid and look at the state");
    else
        backend_.forEach(tables_.counts.total, look, "look at the state");
    place_rigid_ = false;
    reader_.take(backend_, look_words_.span());
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::buildLists() {
    placeRigid();
    lists_stand_ = false;
    NeighbourSettings settings = progress_.moves_rigid != 0 ? kRigidNeighbours : NeighbourSettings{};
    if (progress_.shot_started == 0)
        progress_.lists_last = std::max(progress_.since_build, progress_.lists_last / 2);
    const double wanted = kHorizonLives * std::max(progress_.lists_last, kLeastHorizon) * tables_.time_step;
    settings.longest_horizon = std::min(settings.longest_horizon, wanted);
    settings.set_apart = progress_.left_paths == 0;
    lists_.use(settings);
    lists_.build(data_.particles.in(data_.current), data_.particles.constants.view(), data_.bonds.in());
    progress_.since_build = 0;
    progress_.rebuild = 0;
}

/// s until regimes are decided again at the latest: with the next contact lists, or when the frame is over.
template <class Backend, class Real>
double DeviceSolver<Backend, Real>::untilNextDecision(uint32_t remaining) const {
    const double listed = lists_.horizon() - progress_.since_build * tables_.time_step;
    return std::clamp(listed, 0.0, remaining * tables_.time_step);
}

/// `remaining`: substeps of the frame that are still to come.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::assignRegimes(bool frame_starts, uint32_t remaining) {
    placeRigid();
    lists_stand_ = false;
    regimes_.assign(data_, lists_, clusters_, motion_, params_, frame_starts, progress_.last_frame,
                    untilNextDecision(remaining));
    if (setup_.params.ledger && regimes_.movesRigid()) bookSoftening();
    progress_.last_assigned = progress_.substeps;
    progress_.decide_at =
        regimes_.hitsLater() ? progress_.substeps + regimes_.decisionInterval() : ~uint64_t{0};
    progress_.shot_started = 0;
    progress_.regimes = regimes_.memory();
    progress_.moves_rigid = regimes_.movesRigid() ? 1 : 0;
    countAwake();
}

template <class Backend, class Real>
uint32_t DeviceSolver<Backend, Real>::untilDecision(uint32_t at_most) const {
    return static_cast<uint32_t>(std::min<uint64_t>(at_most, progress_.decide_at - progress_.substeps));
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::bookSoftening() {
    const RigidConstants<Real> constants = regimes_.rigidConstants();
    MeasureEnergy<Real> bonded{data_.arrays(lists_.contacts()), {}, params_, {}, {}, {}, {}};
    MeasureEnergy<Real> carried = bonded, rigid = bonded;
    carried.arrays.constants = Span<const Vec4<Real>>(constants.in_substeps);
    rigid.arrays.constants = Span<const Vec4<Real>>(constants.in_contact_steps);
    rigid.params = rigidParams(params_, kRigidStride);
    backend_.forEach(tables_.counts.total,
                     BookSoftening<Real>{bonded, carried, rigid, clusters_.fragment(), regimes_.regime(),
                                         regimes_.former(), data_.ledger.span()},
                     "book softening");
}

/// Gravity comes on slowly, velocities decay, nothing breaks; then the bodies get the velocities of the
/// set-up (E.4).
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::settle(double seconds, const ProgressCallback& progress) {
    const StepParams<Real> free_params = params_;
    const auto substeps = static_cast<uint64_t>(std::ceil(seconds / tables_.time_step));
    params_.breaking = 0;
    params_.velocity_keep = static_cast<Real>(1 - kSettleDamping * tables_.time_step);
    setVelocities(true);
    while (progress_.substeps < substeps) {
        const double share = static_cast<double>(progress_.substeps) / static_cast<double>(substeps);
        params_.gravity = static_cast<Real>(std::min(1.0, share / kSettleRampShare)) * free_params.gravity;
        for (int chunk = 0; chunk < 5; ++chunk)
            if (runChunk(kBondedStretch.length()) != StepStatus::kOk)
                throw NumericalError(
                    "The bodies blew up while settling: see that none stands in another, or raise "
                    "--substeps.");
        if (progress && !progress(share, "Settling")) throw Cancelled();
    }
    params_ = free_params;
    setVelocities(false);
    backend_.fill(data_.ledger.span(), Vec4<Real>{});
    progress_ = Progress{};
}

/// Zero, or those of the set-up; the low parts of the positions stay.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::setVelocities(bool at_rest) {
    auto& particles = data_.particles;
    auto velocity = backend_.downloaded(particles.velocity[data_.current].view());
    auto spin = backend_.downloaded(particles.spin[data_.current].view());
    for (uint32_t i = 0; i < tables_.counts.in_bodies; ++i) {
        velocity[i] = withW(at_rest ? Vec3<Real>{} : toReal<Real>(tables_.velocity[i]), velocity[i].w);
        spin[i] = withW(at_rest ? Vec3<Real>{} : toReal<Real>(tables_.spin[i]), spin[i].w);
    }
    backend_.upload(particles.velocity[data_.current].span(), velocity.data(), velocity.size());
    backend_.upload(particles.spin[data_.current].span(), spin.data(), spin.size());
    backend_.synchronize();
}

}  // namespace demolish
