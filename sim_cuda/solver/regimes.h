// SPDX-License-Identifier: Apache-2.0
// Only what is breaking pays (architecture 9): decides which fragments are moved with their bonds, which as
// rigid bodies and which not at all; moved_lists.h keeps the lists of each.
//
//   fit (16)-(18) of every fragment -> how calm it is -> islands that may meet -> regime of each fragment
//   -> rigid bodies, particles made to follow them -> marks -> scan -> lists, their lengths to the host
//
// Bonds come to rest only at the start of a frame; they wake whenever contact lists are made, before a hard
// hit and not after it.
#pragma once
#include <algorithm>
#include <cmath>

#include "sim_cuda/kernels/book_bonds.h"
#include "sim_cuda/kernels/in_turn.h"
#include "sim_cuda/solver/clustering.h"
#include "sim_cuda/solver/fragment_motion.h"
#include "sim_cuda/solver/look_interval.h"
#include "sim_cuda/solver/moved_lists.h"
#include "sim_cuda/solver/neighbour_lists.h"
#include "sim_cuda/solver/pending_kicks.h"
#include "sim_cuda/solver/solver_data.h"
#include "sim_cuda/solver/wake_laws.h"

namespace demolish {

/// What a decision leaves to the next; part of a snapshot.
struct RegimeMemory {
    uint32_t awake = 0, must_bond = 0;  ///< particles: that do not sleep; of fragments that need their bonds
    uint32_t all_bonded = 0;            ///< 1: this frame all that is awake is moved with its bonds
};

/// s after which is decided anew while hard hits are ahead: bonds that wake a whole frame before they are hit
/// cost more than the decisions.
inline constexpr double kDecisionSeconds = 0.003;

/// From this share of awake particles on that need their bonds, all are moved with them: two ways of moving
/// side by side cost more than they save.
inline constexpr double kAllBondedShare = 0.8;

template <class Backend, class Real>
class Regimes {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    Regimes(Backend& backend, const SceneSetup& setup, const SceneTables& tables);

    /// From now on: decisions book what they dissipate.
    void keepBooks(bool on) { keeps_books_ = on; }
    /// False: all is moved with its bonds, always, and nothing below is to be called.
    bool on() const { return hand_over_ || sleeping_; }

    /// Decides anew for the present state, whose contact lists must be good. `frame_starts`: `substeps` have
    /// passed since the last frame started, and motion.gather() was called for the state; the last contact
    /// step had `contact_stride`. `soon`: s until the next decision at the latest. Waits.
    void assign(SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
                const Clustering<Backend>& clusters, FragmentMotion<Backend, Real>& motion,
                const StepParams<Real>& params, bool frame_starts, uint32_t substeps, uint32_t contact_stride,
                double soon);
    /// Contact lists were made within a frame, and nothing is rigid: does something that is awake come near
    /// something asleep within `soon`, so that all must be decided anew? Waits.
    bool stirs(SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
               const Clustering<Backend>& clusters, double soon);
    /// Puts all particles of rigid fragments where those are.
    PlaceRigid<Real> placer(SolverData<Backend, Real>& data, const Clustering<Backend>& clusters);
    /// The bodies have stood still for long: they may sleep at once.
    void markRested();
    /// Before clustering finds them: pieces of rigid bodies that come apart go on as those did.
    void splitRigid(const Clustering<Backend>& clusters, Span<const uint32_t> owner,
                    Span<const uint32_t> splits);
    /// What anchors hold of the fragments, for decisions from now on.
    void noteHolds(const HoldsIn& holds) { holds_ = holds; }
    /// The bodies of what they hold move as that does; its velocities have been set.
    void leadBodies(SolverData<Backend, Real>& data, const Clustering<Backend>& clusters);
    /// What decisions read, with contact lists that are good. soon: as in assign().
    MeetingsIn<Real> meetingsOf(SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
                                const Clustering<Backend>& clusters, double soon);

    const RegimeMemory& memory() const { return memory_; }
    /// For an earlier state that has been put back.
    void remember(const RegimeMemory& memory) {
        memory_ = memory;
        lists_stand_ = false;
    }
    /// What moves how is listed as the present state has it: not from the return to an earlier one to the
    /// next decision.
    bool listsStand() const { return lists_stand_; }

    const RigidWork& rigid() const { return moved_.rigid(); }
    RigidConstants<Real> rigidConstants() { return moved_.rigidConstants(); }
    /// A ball about to hit hard is stepped so even where nothing else is, or it would hang in the air.
    bool movesBonds() const {
        return moved_.count(kBondedCount) > 0 || bonded_shots_ || moved_.count(kBondedShots) > 0;
    }
    /// Something is rigid or sleeps, so that what meets it has to be known beforehand.
    bool leavesBonds() const { return movesRigid() || moved_.count(kAsleepCount) > 0; }
    bool movesRigid() const { return moved_.count(kFragmentCount) > 0; }
    /// Some rigid fragment may touch what is moved with its bonds, so that substeps carry it along.
    bool carries() const { return moved_.count(kCarriedCount) > 0; }
    double gentlestHit() const { return gentlest_hit_; }  ///< m/s: no slower meeting wakes bonds
    /// Somebody will be hit hard before the next decision but not at once, and has not been woken for it:
    /// decide anew within decisionInterval() substeps.
    bool hitsLater() const { return moved_.count(kHitsLater) != 0; }
    uint32_t decisionInterval() const { return decision_substeps_; }
    uint32_t bondedParticles() const { return moved_.count(kBondedCount); }
    uint32_t carriedParticles() const { return moved_.count(kCarriedCount); }
    uint32_t activeParticles() const { return moved_.count(kActiveCount); }
    uint32_t rigidFragments() const { return moved_.count(kFragmentCount); }
    uint32_t sleepingFragments() const { return moved_.count(kAsleepCount); }
    uint32_t awakeBodies() const { return moved_.count(kAwakeBodies); }

    /// Calls visit(buffer) for what a checkpoint has to keep.
    template <class Visit>
    void visitBuffers(const Visit& visit) {
        visit(regime_);
        visit(clock_);
        visit(body_memory_);
        visit(former_pose_);
    }
    Span<const uint32_t> regime() const { return regime_.view(); }
    Span<const BodyMemory> bodyMemory() const { return body_memory_.view(); }
    Span<const uint32_t> former() const { return former_.view(); }  ///< before the last decision

  private:
    void watchClocks(SolverData<Backend, Real>& data, const Clustering<Backend>& clusters,
                     const FragmentMotion<Backend, Real>& motion, uint32_t substeps, double substep);
    /// Gives how regimes then are to be chosen.
    ChooseRegimes<Real> flagIslands(const MeetingsIn<Real>& meetings, const FragmentRows& rows,
                                    const StepParams<Real>& params, bool frame_starts);
    void startBodies(const ChooseRegimes<Real>& choose, SolverData<Backend, Real>& data,
                     NeighbourLists<Backend, Real>& lists, const MeetingsIn<Real>& meetings,
                     const FragmentRows& rows, const FragmentMotion<Backend, Real>& motion,
                     const StepParams<Real>& params, bool frame_starts, uint32_t substeps,
                     uint32_t contact_stride);

    Backend& backend_;
    ParticleCounts counts_of_;
    bool hand_over_, sleeping_, no_bonds_, keeps_books_ = false;
    uint32_t decision_substeps_;
    double at_once_;              ///< s
    double gentlest_hit_ = 1e30;  ///< m/s
    uint32_t calm_substeps_, rest_substeps_, crumb_;
    Buffer<double> calm_speed2_;
    Buffer<WakeLaw<Real>> wake_;
    Buffer<uint32_t> regime_, former_, island_, flags_, meets_, speeds_;
    Buffer<BodyMemory> body_memory_;
    Buffer<CalmClock> clock_;
    Buffer<FormerPose> former_pose_;
    MovedLists<Backend, Real> moved_;
    PendingKickSums<Backend, Real> pending_;
    typename Backend::Reader reader_;
    Span<const RigidMotion> fits_;  ///< of the frame's start
    RegimeMemory memory_;
    HoldsIn holds_;
    bool bonded_shots_ = true;  ///< before the first decision, while bodies settle, everything is
    bool lists_stand_ = true;   ///< before it nothing is listed, which is right
};

template <class Backend, class Real>
Regimes<Backend, Real>::Regimes(Backend& backend, const SceneSetup& setup, const SceneTables& tables)
    : backend_(backend),
      counts_of_(tables.counts),
      hand_over_(setup.params.hand_over &&
                 (setup.params.preset_pieces.has_value() || tables.time_step <= kLongestHandOverStep)),
      sleeping_(setup.params.sleeping),
      no_bonds_(setup.params.preset_pieces.has_value()),
      decision_substeps_(
          kRigidStretch.length() *
          static_cast<uint32_t>(std::ceil(kDecisionSeconds / (kRigidStretch.length() * tables.time_step)))),
      at_once_((decision_substeps_ + kRigidStride) * tables.time_step),
      calm_substeps_(static_cast<uint32_t>(std::ceil(kCalmSeconds / tables.time_step))),
      rest_substeps_(static_cast<uint32_t>(std::ceil(kRestSeconds / tables.time_step))),
      crumb_(hand_over_ ? crumbParticles(static_cast<double>(tables.counts.in_bodies) / tables.bodies) : 1),
      moved_(backend),
      pending_(backend),
      reader_(backend) {
    keepBooks(setup.params.ledger);
    if (!on()) return;
    const uint32_t total = counts_of_.total;
    const WakeLaws<Real> laws = wakeLaws<Real>(setup, tables);
    gentlest_hit_ = laws.gentlest_hit;
    calm_speed2_ = backend.uploaded(laws.calm_speed2);
    wake_ = backend.uploaded(laws.wake);
    for (Buffer<uint32_t>* words : {&regime_, &former_, &island_, &flags_, &meets_, &speeds_})
        *words = backend.template allocate<uint32_t>(total);
    body_memory_ = backend.template allocate<BodyMemory>(total);
    clock_ = backend.template allocate<CalmClock>(total);
    former_pose_ = backend.template allocate<FormerPose>(total);
    moved_.allocate(tables);
    pending_.allocate(total);
    backend.synchronize();  // the host copies go out of scope
}

template <class Backend, class Real>
PlaceRigid<Real> Regimes<Backend, Real>::placer(SolverData<Backend, Real>& data,
                                                const Clustering<Backend>& clusters) {
    return {clusters.fragment(),
            regime_.view(),
            moved_.bodies(),
            moved_.arms(),
            moved_.startRotations(),
            data.particles.out(data.current),
            data.particles.out(1 - data.current)};
}

template <class Backend, class Real>
void Regimes<Backend, Real>::leadBodies(SolverData<Backend, Real>& data,
                                        const Clustering<Backend>& clusters) {
    backend_.forEach(counts_of_.in_bodies,
                     LeadBodies<Real>{holds_, clusters.fragment(), regime_.view(),
                                      data.particles.in(data.current), moved_.bodies()},
                     "lead bodies");
}

template <class Backend, class Real>
void Regimes<Backend, Real>::markRested() {
    if (on()) backend_.fill(clock_.span(), CalmClock{calm_substeps_, rest_substeps_});
}

template <class Backend, class Real>
void Regimes<Backend, Real>::splitRigid(const Clustering<Backend>& clusters, Span<const uint32_t> owner,
                                        Span<const uint32_t> splits) {
    backend_.forEach(
        counts_of_.in_bodies,
        SplitRigid{clusters.fragment(), owner, splits, regime_.span(), body_memory_.span(), clock_.span()},
        "split rigid bodies");
}

template <class Backend, class Real>
void Regimes<Backend, Real>::assign(SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
                                    const Clustering<Backend>& clusters,
                                    FragmentMotion<Backend, Real>& motion, const StepParams<Real>& params,
                                    bool frame_starts, uint32_t substeps, uint32_t contact_stride,
                                    double soon) {
    const FragmentRows rows = clusters.rows();
    const StateIn<Real> state = data.particles.in(data.current);
    if (frame_starts) {
        fits_ = motion.fitMotions(rows, state, data.ownMasses());
        watchClocks(data, clusters, motion, substeps, double(params.dt));
    }
    const MeetingsIn<Real> meetings = meetingsOf(data, lists, clusters, soon);
    const ChooseRegimes<Real> choose = flagIslands(meetings, rows, params, frame_starts);
    startBodies(choose, data, lists, meetings, rows, motion, params, frame_starts, substeps, contact_stride);
    const Span<const uint32_t> meets = frame_starts ? Span<const uint32_t>{} : meets_.view();
    moved_.list(data, meetings, rows, params.colliders,
                {regime_.view(), flags_.view(), meets, body_memory_.span()});
    bonded_shots_ = !hand_over_;
    lists_stand_ = true;
    if (frame_starts) {
        memory_.awake = moved_.count(kAwakeCount);
        memory_.must_bond = moved_.count(kMustBondCount);
    }
}

template <class Backend, class Real>
MeetingsIn<Real> Regimes<Backend, Real>::meetingsOf(SolverData<Backend, Real>& data,
                                                    NeighbourLists<Backend, Real>& lists,
                                                    const Clustering<Backend>& clusters, double soon) {
    return {data.particles.in(data.current),
            lists.contacts().paths(),
            data.particles.constants.view(),
            clusters.fragment(),
            data.particles.owner.view(),
            data.bonds.in(),
            lists.contacts().in(),
            counts_of_.in_bodies,
            static_cast<Real>(lists.horizon()),
            static_cast<Real>(soon),
            static_cast<Real>(std::min(soon, at_once_))};
}

template <class Backend, class Real>
bool Regimes<Backend, Real>::stirs(SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
                                   const Clustering<Backend>& clusters, double soon) {
    if (moved_.count(kAsleepCount) == 0) return false;
    const Span<uint32_t> word = flags_.span().part(0, 1);
    backend_.fill(word, 0u);
    withMeetingThreads<Backend>(counts_of_.total, [&](auto threads) {
        constexpr uint32_t kThreads = decltype(threads)::kFirst;
        backend_.forEach(
            size_t{counts_of_.total} * kThreads,
            SeeSleepers<kThreads, Real>{meetingsOf(data, lists, clusters, soon), regime_.view(), word},
            "see sleepers");
    });
    reader_.start(backend_, word);
    return reader_.wait()[0] != 0;
}

template <class Backend, class Real>
void Regimes<Backend, Real>::watchClocks(SolverData<Backend, Real>& data, const Clustering<Backend>& clusters,
                                         const FragmentMotion<Backend, Real>& motion, uint32_t substeps,
                                         double substep) {
    const uint32_t total = counts_of_.total;
    const auto constants = data.particles.constants.view();
    const auto state = data.particles.in(data.current);
    backend_.fill(speeds_.span(), 0u);
    backend_.forEach(total,
                     MeasureMotion<Real>{state, constants, clusters.fragment(), former_pose_.span(),
                                         speeds_.span(), substeps * substep},
                     "measure motion");
    backend_.forEach(
        total,
        AdvanceClocks<Real>{clusters.rows(), clusters.fragment(), data.particles.owner.view(), speeds_.view(),
                            constants, fits_, motion.poses(), motion.spins(), calm_speed2_.view(),
                            motion.ages(), clock_.span(), float(kRestSpeed * kRestSpeed),
                            counts_of_.in_bodies, substeps, holds_, state},
        "advance clocks");
}

template <class Backend, class Real>
ChooseRegimes<Real> Regimes<Backend, Real>::flagIslands(const MeetingsIn<Real>& meetings,
                                                        const FragmentRows& rows,
                                                        const StepParams<Real>& params, bool frame_starts) {
    const uint32_t total = counts_of_.total;
    const bool most_bonded = !no_bonds_ && memory_.must_bond > kAllBondedShare * memory_.awake;
    if (frame_starts) memory_.all_bonded = most_bonded ? 1 : 0;
    const RegimeRules rules{hand_over_, sleeping_,      frame_starts,  memory_.all_bonded != 0,
                            no_bonds_,  calm_substeps_, rest_substeps_};
    HitRules<Real> hits{
        meetings, rows, regime_.view(), wake_.view(), crumb_, holds_, Real(kRigidStride) * params.dt};
    if (meetings.bonds.facing > 0) hits.coming = speeds_.span();  // which are those of a frame's start
    const HitsOnColliders<Real> landing{params.colliders, params.gravity, hits.contact_step};
    const Span<uint32_t> words = moved_.words();
    backend_.forEach(total,
                     StartIslands{island_.span(), flags_.span(), meets_.span(), moved_.activeMarks(),
                                  moved_.carriedMarks(), words, moved_.bodyAwake(), hits.coming},
                     "start islands");
    withMeetingThreads<Backend>(counts_of_.total, [&](auto threads) {
        constexpr uint32_t kFirst = decltype(threads)::kFirst, kLater = decltype(threads)::kLater;
        backend_.forEach(size_t{total} * kFirst,
                         JoinIslands<kFirst, Real>{hits, landing, island_.span(), meets_.span(), words},
                         "join islands");
        backend_.forEach(total, FlattenLabels{island_.span()}, "flatten islands");
        const FlagIslands<kLater, Real> flag{hits,    island_.view(), meets_.view(), clock_.view(),
                                             landing, rules,          flags_.span(), words};
        backend_.forEach(size_t{total} * kLater, flag, "flag islands");
    });
    return {meetings.label, island_.view(), flags_.view(), meetings.constants,   rules,
            regime_.span(), former_.span(), clock_.span(), counts_of_.in_bodies, holds_};
}

template <class Backend, class Real>
void Regimes<Backend, Real>::startBodies(const ChooseRegimes<Real>& choose, SolverData<Backend, Real>& data,
                                         NeighbourLists<Backend, Real>& lists,
                                         const MeetingsIn<Real>& meetings, const FragmentRows& rows,
                                         const FragmentMotion<Backend, Real>& motion,
                                         const StepParams<Real>& params, bool frame_starts, uint32_t substeps,
                                         uint32_t contact_stride) {
    auto& particles = data.particles;
    const uint32_t total = counts_of_.total;
    const StartBodies<Real> start{rows,
                                  meetings.label,
                                  regime_.view(),
                                  former_.view(),
                                  body_memory_.span(),
                                  meetings.state,
                                  meetings.constants,
                                  fits_,
                                  motion.poses(),
                                  motion.spins(),
                                  moved_.bodies(),
                                  counts_of_.in_bodies,
                                  frame_starts,
                                  holds_};
    StartVelocities<Real> velocities = data.startVelocities(
        rows, motion.poses(), holds_, (0.5 * substeps) * double(params.dt) * asDouble(params.gravity));
    velocities.moved = {regime_.view(), former_.view(), moved_.bodies(), frame_starts};
    RigidWork bodies;
    bodies.body = moved_.bodies();
    bodies.label = meetings.label;
    const PendingKicks pending =
        pending_.of(bodies, regime_.view(), former_.view(), contact_stride, double(params.dt));
    backend_.forEach(total, InTurn{InTurn{choose, pending}, InTurn{start, velocities}},
                     "choose regimes and start bodies");
    SubstepArrays<Real> arrays = data.arrays(lists.contacts());
    arrays.carried_tally = moved_.carriedTally();
    pending_.gather(arrays, params, bodies, pending, contact_stride, keeps_books_);
    if (frame_starts && keeps_books_)
        backend_.forEach(counts_of_.in_bodies,
                         BookBondsAtRest<Real>{arrays, meetings.label, regime_.view(), former_.view(),
                                               data.ledger.span(), double(params.dt)},
                         "book bonds at rest");
    backend_.forEach(
        total,
        SettleRegimes<Real>{meetings.state, particles.out(data.current), particles.out(1 - data.current),
                            meetings.constants, meetings.label, regime_.view(), former_.view(),
                            body_memory_.view(), moved_.bodies(), moved_.arms(), moved_.startRotations(),
                            data.ledger.span(), pending, arrays, velocities.start, asDouble(params.gravity),
                            double(params.dt), counts_of_.in_bodies, frame_starts},
        "settle regimes");
}

}  // namespace demolish
