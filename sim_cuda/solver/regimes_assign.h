// SPDX-License-Identifier: Apache-2.0
// The steps of a decision. Part of regimes.h.
#pragma once
#include "sim_cuda/kernels/in_turn.h"
#include "sim_cuda/solver/regimes.h"

namespace demolish {

template <class Backend, class Real>
void Regimes<Backend, Real>::assign(SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
                                    const Clustering<Backend>& clusters,
                                    FragmentMotion<Backend, Real>& motion, const StepParams<Real>& params,
                                    bool frame_starts, uint32_t substeps, double soon) {
    const FragmentRows rows = clusters.rows();
    const StateIn<Real> state = data.particles.in(data.current);
    const Span<const ParticleConstants<Real>> constants = data.particles.constants.view();
    if (frame_starts) {
        fits_ = motion.fitMotions(rows, state, constants);
        watchClocks(data, clusters, motion, substeps);
    }
    const MeetingsIn<Real> meetings = meetingsOf(data, lists, clusters, soon);
    const ChooseRegimes<Real> choose = flagIslands(meetings, rows, params, frame_starts);
    startBodies(choose, data, meetings, rows, motion, params, frame_starts);
    listWork(data, meetings, rows, params, frame_starts);
    if constexpr (!Backend::kOnGpu) listBondsOnHost(data, clusters);
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
    if (counts_[kAsleepCount] == 0) return false;
    const Span<uint32_t> word = flags_.span().part(0, 1);
    backend_.fill(word, 0u);
    withThreads([&](auto threads) {
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
                                         const FragmentMotion<Backend, Real>& motion, uint32_t substeps) {
    const uint32_t total = counts_of_.total;
    const Span<const ParticleConstants<Real>> constants = data.particles.constants.view();
    backend_.fill(speeds_.span(), 0u);
    backend_.forEach(
        total,
        MeasureMotion<Real>{data.particles.in(data.current), constants, clusters.fragment(), speeds_.span()},
        "measure motion");
    backend_.forEach(total,
                     AdvanceClocks<Real>{
                         clusters.rows(), clusters.fragment(), data.particles.owner.view(), speeds_.view(),
                         constants, fits_, motion.poses(), motion.spins(), calm_speed2_.view(), clock_.span(),
                         static_cast<float>(kRestSpeed * kRestSpeed), counts_of_.in_bodies, substeps},
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
    const HitRules<Real> hits{meetings, rows, regime_.view(), wake_.view(), crumb_};
    const Span<uint32_t> marks = marks_.span();
    backend_.forEach(total,
                     StartIslands{island_.span(), flags_.span(), meets_.span(), marks.part(0, total),
                                  marks.part(3 * size_t{total}, total), words_.span(), body_awake_.span()},
                     "start islands");
    withThreads([&](auto threads) {
        constexpr uint32_t kFirst = decltype(threads)::kFirst, kLater = decltype(threads)::kLater;
        backend_.forEach(size_t{total} * kFirst,
                         JoinIslands<kFirst, Real>{hits, island_.span(), meets_.span(), words_.span()},
                         "join islands");
        backend_.forEach(total, FlattenLabels{island_.span()}, "flatten islands");
        const FlagIslands<kLater, Real> flag{hits,          island_.view(),   meets_.view(),
                                             clock_.view(), params.colliders, params.gravity,
                                             rules,         flags_.span(),    words_.span()};
        backend_.forEach(size_t{total} * kLater, flag, "flag islands");
    });
    return {meetings.label, island_.view(), flags_.view(), meetings.constants,  rules,
            regime_.span(), former_.span(), clock_.span(), counts_of_.in_bodies};
}

template <class Backend, class Real>
void Regimes<Backend, Real>::startBodies(const ChooseRegimes<Real>& choose, SolverData<Backend, Real>& data,
                                         const MeetingsIn<Real>& meetings, const FragmentRows& rows,
                                         const FragmentMotion<Backend, Real>& motion,
                                         const StepParams<Real>& params, bool frame_starts) {
    auto& particles = data.particles;
    const uint32_t total = counts_of_.total;
    const StartBodies<Real> start{
        rows,           meetings.label,       regime_.view(), former_.view(), body_memory_.view(),
        meetings.state, meetings.constants,   fits_,          motion.poses(), motion.spins(),
        body_.span(),   counts_of_.in_bodies, frame_starts};
    backend_.forEach(total, InTurn{choose, start}, "choose regimes and start bodies");
    backend_.forEach(
        total,
        SettleRegimes<Real>{meetings.state, particles.out(data.current), particles.out(1 - data.current),
                            meetings.constants, meetings.label, regime_.view(), former_.view(), body_.view(),
                            arm_.span(), start_rotation_.span(), data.ledger.span(), asDouble(params.gravity),
                            double(params.dt), counts_of_.in_bodies, frame_starts},
        "settle regimes");
}

template <class Backend, class Real>
void Regimes<Backend, Real>::listWork(SolverData<Backend, Real>& data, const MeetingsIn<Real>& meetings,
                                      const FragmentRows& rows, const StepParams<Real>& params,
                                      bool frame_starts) {
    const uint32_t total = counts_of_.total;
    const PlacesIn places{rows, counts_of_.in_bodies, total};
    const Span<uint32_t> marks = marks_.span();
    withThreads([&](auto threads) {
        constexpr uint32_t kLater = decltype(threads)::kLater;
        backend_.forEach(
            size_t{total} * kLater,
            MarkWork<kLater, Real>{
                meetings, places, regime_.view(), frame_starts ? Span<const uint32_t>{} : meets_.view(),
                params.colliders, marks.part(0, total), marks.part(total, total),
                marks.part(2 * size_t{total}, total), marks.part(3 * size_t{total}, total)},
            "mark work");
    });
    backend_.exclusiveScan(marks, mark_sums_.span());
    const WriteWork<Real> write{places,
                                meetings.label,
                                regime_.view(),
                                mark_sums_.view(),
                                meetings.owner,
                                flags_.view(),
                                body_.view(),
                                arm_.view(),
                                body_memory_.view(),
                                meetings.constants,
                                active_.span(),
                                fragment_.span(),
                                first_.span(),
                                last_.span(),
                                bonded_.span(),
                                large_.span(),
                                words_.span(),
                                body_awake_.span(),
                                rigid_constants_.span(),
                                in_substeps_.span()};
    backend_.forEach(total, write, "write work");
    reader_.start(backend_, words_.view());
    std::copy_n(reader_.wait().begin(), kWorkWords, counts_);
    if (frame_starts) {
        memory_.awake = counts_[kAwakeCount];
        memory_.must_bond = counts_[kMustBondCount];
    }
    useLists(data, meetings);
}

template <class Backend, class Real>
void Regimes<Backend, Real>::useLists(SolverData<Backend, Real>& data, const MeetingsIn<Real>& meetings) {
    bonded_shots_ = !hand_over_;
    rigid_ = {fragment_.view(),
              first_.view(),
              last_.view(),
              active_.view(),
              large_.view(),
              words_.view(),
              body_.span(),
              body_memory_.span(),
              arm_.view(),
              start_rotation_.view(),
              meetings.label,
              counts_[kActiveCount],
              counts_[kFragmentCount],
              counts_[kLargeCount]};
    data.work = BondedWork{};
    if (counts_[kBondedCount] != counts_of_.in_bodies) {
        data.work.ids = bonded_.view();
        data.work.count = words_.view().part(kBondedCount, 2);
        data.work.at_most = counts_[kBondedCount] + counts_[kCarriedCount];
    }
    data.work.regime = regime_.view();
    data.constants_in_substeps = movesRigid() ? in_substeps_.view() : Span<const ParticleConstants<Real>>{};
    data.carried = carried_.span();
    data.carried_tally = carried_tally_.span();
}

/// A solid bond joins particles of one fragment, so that one end tells.
template <class Backend, class Real>
void Regimes<Backend, Real>::listBondsOnHost(SolverData<Backend, Real>& data,
                                             const Clustering<Backend>& clusters) {
    if (data.work.all()) return;
    const Span<const uint32_t> label = clusters.fragment(), slot_of_bond = data.bonds.slot_of_bond.view();
    const Span<const BondLink> link = data.bonds.link.view();
    uint32_t count = 0;
    for (uint32_t b = 0; b < data.bonds.count; ++b) {
        const BondLink bond = link[slot_of_bond[b]];
        const bool moved = regime_.view()[label[linkedParticle(bond)]] == wordOf(Regime::kBonded);
        if (moved && isBonded(bond)) bonds_.span()[count++] = b;
    }
    data.work.bonds = bonds_.view().part(0, count);
}

}  // namespace demolish
