// SPDX-License-Identifier: Apache-2.0
// What regimes mean for the steps: the rigid bodies, and lists of what moves how (kernels/work_lists.h), with
// their lengths on the host.
#pragma once
#include <algorithm>

#include "sim_cuda/kernels/start_rigid.h"
#include "sim_cuda/kernels/work_lists.h"
#include "sim_cuda/solver/solver_data.h"

namespace demolish {

/// visit(MeetingThreads): how many threads share the meetings of one of `total` particles.
template <class Backend, class Visit>
void withMeetingThreads(uint32_t total, const Visit& visit) {
    if constexpr (!Backend::kOnGpu)
        visit(MeetingThreads<1, 1>{});
    else if (total <= kFewToDecide)
        visit(ThreadsOfFew{});
    else
        visit(ThreadsOfMany{});
}

/// A decision, by the slot of each fragment.
struct Decision {
    Span<const uint32_t> regime, flags;
    Span<const uint32_t> meets;    ///< per particle; empty: particles have been moved since
    Span<BodyMemory> body_memory;  ///< of rigid fragments, from step to step
};

template <class Backend, class Real>
class MovedLists {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Keeps a reference to the backend. Nothing is listed: all is moved with its bonds.
    explicit MovedLists(Backend& backend) : backend_(backend), reader_(backend) {}
    void allocate(const SceneTables& tables);

    // For a decision, cleared by StartIslands:
    Span<uint32_t> activeMarks() { return marks_.span().part(0, counts_of_.total); }
    Span<uint32_t> carriedMarks() {
        return marks_.span().part(3 * size_t{counts_of_.total}, counts_of_.total);
    }
    Span<uint32_t> words() { return words_.span(); }
    Span<uint32_t> bodyAwake() { return body_awake_.span(); }
    // of fragments and particles, as they become rigid:
    Span<RigidBody> bodies() { return body_.span(); }
    Span<Vec3<double>> arms() { return arm_.span(); }
    Span<Quat<double>> startRotations() { return start_rotation_.span(); }
    /// Four a particle, all 0 between two steps (SubstepArrays).
    Span<Vec4<Real>> carriedTally() { return carried_tally_.span(); }

    /// Lists what moves how by a decision, and tells `data` what substeps go by. Waits.
    void list(SolverData<Backend, Real>& data, const MeetingsIn<Real>& meetings, const FragmentRows& rows,
              const ColliderSet<Real>& colliders, const Decision& decision);

    const RigidWork& rigid() const { return rigid_; }
    RigidConstants<Real> rigidConstants() { return {rigid_constants_.span(), in_substeps_.span()}; }
    uint32_t count(uint32_t word) const { return counts_[word]; }  ///< kActiveCount and others

  private:
    void write(const MeetingsIn<Real>& meetings, const PlacesIn& places, const Decision& decision);
    void use(SolverData<Backend, Real>& data, const MeetingsIn<Real>& meetings, const Decision& decision);
    void listBondsOnHost(SolverData<Backend, Real>& data, Span<const uint32_t> label);

    Backend& backend_;
    ParticleCounts counts_of_;
    Buffer<RigidBody> body_;
    Buffer<Vec3<double>> arm_;
    Buffer<Quat<double>> start_rotation_;
    Buffer<ParticleConstants<Real>> rigid_constants_, in_substeps_;
    Buffer<Vec4<Real>> carried_, carried_tally_;  ///< as in SubstepArrays
    Buffer<uint32_t> marks_, mark_sums_;
    Buffer<uint32_t> active_, fragment_, first_, last_, bonded_, large_, bonds_, body_awake_, words_;
    typename Backend::Reader reader_;
    RigidWork rigid_;
    uint32_t counts_[kWorkWords] = {};
};

template <class Backend, class Real>
void MovedLists<Backend, Real>::allocate(const SceneTables& tables) {
    counts_of_ = tables.counts;
    const size_t total = counts_of_.total;
    for (Buffer<uint32_t>* ids : {&active_, &fragment_, &first_, &last_, &large_})
        *ids = backend_.template allocate<uint32_t>(total);
    body_ = backend_.template allocate<RigidBody>(total);
    arm_ = backend_.template allocate<Vec3<double>>(total);
    start_rotation_ = backend_.template allocate<Quat<double>>(total);
    rigid_constants_ = backend_.template allocate<ParticleConstants<Real>>(total);
    in_substeps_ = backend_.template allocate<ParticleConstants<Real>>(total);
    carried_ = backend_.template allocate<Vec4<Real>>(2 * total);
    carried_tally_ = backend_.template allocate<Vec4<Real>>(4 * total);
    marks_ = backend_.template allocate<uint32_t>(kMarkRows * total);
    mark_sums_ = backend_.template allocate<uint32_t>(kMarkRows * total + 1);
    bonded_ = backend_.template allocate<uint32_t>(counts_of_.in_bodies);
    words_ = backend_.template allocate<uint32_t>(kWorkWords);
    body_awake_ = backend_.template allocate<uint32_t>(tables.bodies);
    if constexpr (!Backend::kOnGpu) bonds_ = backend_.template allocate<uint32_t>(tables.slot_of_bond.size());
}

template <class Backend, class Real>
void MovedLists<Backend, Real>::list(SolverData<Backend, Real>& data, const MeetingsIn<Real>& meetings,
                                     const FragmentRows& rows, const ColliderSet<Real>& colliders,
                                     const Decision& decision) {
    const uint32_t total = counts_of_.total;
    const PlacesIn places{rows, counts_of_.in_bodies, total};
    const Span<uint32_t> marks = marks_.span();
    withMeetingThreads<Backend>(total, [&](auto threads) {
        constexpr uint32_t kLater = decltype(threads)::kLater;
        backend_.forEach(size_t{total} * kLater,
                         MarkWork<kLater, Real>{meetings, places, decision.regime, decision.meets, colliders,
                                                activeMarks(), marks.part(total, total),
                                                marks.part(2 * size_t{total}, total), carriedMarks()},
                         "mark work");
    });
    backend_.exclusiveScan(marks, mark_sums_.span());
    write(meetings, places, decision);
    reader_.start(backend_, words_.view());
    std::copy_n(reader_.wait().begin(), kWorkWords, counts_);
    use(data, meetings, decision);
    if constexpr (!Backend::kOnGpu) listBondsOnHost(data, meetings.label);
}

template <class Backend, class Real>
void MovedLists<Backend, Real>::write(const MeetingsIn<Real>& meetings, const PlacesIn& places,
                                      const Decision& decision) {
    const WriteWork<Real> write{places,
                                meetings.label,
                                decision.regime,
                                mark_sums_.view(),
                                meetings.owner,
                                decision.flags,
                                body_.view(),
                                arm_.view(),
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
    backend_.forEach(counts_of_.total, write, "write work");
}

/// What the steps go by from now on: the lists and their lengths as the host knows them.
template <class Backend, class Real>
void MovedLists<Backend, Real>::use(SolverData<Backend, Real>& data, const MeetingsIn<Real>& meetings,
                                    const Decision& decision) {
    rigid_ = {fragment_.view(),
              first_.view(),
              last_.view(),
              active_.view(),
              large_.view(),
              words_.view(),
              body_.span(),
              decision.body_memory,
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
    data.work.regime = decision.regime;
    const bool something_rigid = counts_[kFragmentCount] > 0;
    data.constants_in_substeps =
        something_rigid ? in_substeps_.view() : Span<const ParticleConstants<Real>>{};
    data.carried = carried_.span();
    data.carried_tally = carried_tally_.span();
}

/// A solid bond joins particles of one fragment, so that one end tells.
template <class Backend, class Real>
void MovedLists<Backend, Real>::listBondsOnHost(SolverData<Backend, Real>& data, Span<const uint32_t> label) {
    if (data.work.all()) return;
    const Span<const uint32_t> slot_of_bond = data.bonds.slot_of_bond.view();
    const Span<const BondLink> link = data.bonds.link.view();
    uint32_t count = 0;
    for (uint32_t b = 0; b < data.bonds.count; ++b) {
        const BondLink bond = link[slot_of_bond[b]];
        const bool moved = data.work.regime[label[linkedParticle(bond)]] == wordOf(Regime::kBonded);
        if (moved && isBonded(bond)) bonds_.span()[count++] = b;
    }
    data.work.bonds = bonds_.view().part(0, count);
}

}  // namespace demolish
