// SPDX-License-Identifier: Apache-2.0
// Contact lists: which pairs may touch for a while, found on the paper's uniform grid (3.3.1).
//
//   start paths -> velocity ranges -> who is fast -> common velocity, horizon -> count in buckets -> scan ->
//   fill buckets
//               -> find pairs into drafts -> scan -> write rows sorted, with the springs of the rows before
//
// Soundness: kernels/predicted_path.h. Everything is counted in whole numbers and every choice is made on
// equal bits, so the rows are the same on every device and for any number of threads.
//
// The host learns how long the rows are while they are written already; should they not fit, they are
// written again.
#pragma once
#include <algorithm>
#include <bit>
#include <utility>

#include "sim_cuda/data/bonds.h"
#include "sim_cuda/kernels/choose_frame.h"
#include "sim_cuda/kernels/fill_grid.h"
#include "sim_cuda/kernels/insert_pairs.h"
#include "sim_cuda/kernels/start_paths.h"
#include "sim_cuda/kernels/write_neighbours.h"
#include "sim_cuda/solver/neighbour_settings.h"
#include "sim_cuda/solver/pair_finder.h"

namespace demolish {

template <class Backend, class Real>
class NeighbourLists {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Lists are empty before the first build. `largest_radius`: of R_c among the bodies' particles, m, > 0.
    NeighbourLists(Backend& backend, ParticleCounts counts, double largest_radius,
                   const NeighbourSettings& settings = {});

    /// Of each particle of a body: 1 if nothing can touch it while its bonds hold (buriedParticles). Without
    /// this everything is searched for.
    void setBuried(const std::vector<uint32_t>& buried) {
        buried_ = backend_.uploaded(buried);
        backend_.synchronize();  // the host copy goes out of scope
    }
    /// For the builds to come.
    void use(const NeighbourSettings& settings) { settings_ = settings; }

    /// Builds the rows from the present state. Waits for their length, not for the rows. Needed at the start,
    /// when elapsed + lookahead passes horizon(), when too many leave their paths, and when a projectile
    /// starts.
    void build(const StateIn<Real>& state, Span<const ParticleConstants<Real>> constants,
               const BondRowsIn<Real>& bonds);

    /// Makes room for `used` entries that the caller writes (a state put back) and takes over their horizon
    /// (s).
    void adopt(uint32_t used, double horizon) {
        horizon_ = horizon;
        contacts_.used = used;
        makeRoom();
    }

    /// s after the last build.
    double horizon() const { return horizon_; }
    /// Puts more entries into the rows: of each pair both, none twice. They may come in any order. Does not
    /// wait unless there is no room.
    void insert(Span<const uint64_t> entries);
    /// By these bonds.
    Enclosures enclosures(const BondRowsIn<Real>& bonds) const {
        return {buried_.view(), bonds.row_start, bonds.link, counts_.in_bodies};
    }
    /// Builds so far.
    uint64_t builds() const { return builds_; }

    ContactArrays<Backend, Real>& contacts() { return contacts_; }
    const ContactArrays<Backend, Real>& contacts() const { return contacts_; }

  private:
    void startPaths(const StateIn<Real>& state, Span<const ParticleConstants<Real>> constants,
                    const BondRowsIn<Real>& bonds);
    void chooseFrame(const StateIn<Real>& state, Span<const ParticleConstants<Real>> constants);
    void seekFast(const StateIn<Real>& state, Span<const ParticleConstants<Real>> constants);
    void fillGrid();
    void findPairs(const NeighbourSearch<Real>& search);
    void writeRows(const NeighbourSearch<Real>& search);
    void makeRoom();
    void exchangeRows() {
        std::swap(contacts_.row_start, former_.row_start);
        std::swap(contacts_.neighbour, former_.neighbour);
        std::swap(contacts_.spring, former_.spring);
    }
    FormerRows<Real> formerRows() const {
        return {former_.row_start.view(), former_.neighbour.view(), former_.spring.view()};
    }
    NeighbourSearch<Real> searchOf(const BondRowsIn<Real>& bonds);

    uint32_t shots() const { return counts_.total - counts_.in_bodies; }
    /// Parts of zeroed_, one after the other.
    Span<uint32_t> bucketCounters() { return zeroed_.span().part(0, mask_ + 1); }
    Span<uint32_t> rowCounts() { return zeroed_.span().part(mask_ + 1, counts_.in_bodies + bit_words_); }
    Span<uint32_t> bits() { return zeroed_.span().part(mask_ + 1 + rowCounts().count, bit_words_); }
    Span<uint32_t> velocityBins() {
        return zeroed_.span().part(mask_ + 1 + rowCounts().count + bit_words_, 3 * kVelocityBins);
    }
    /// How many are outside the slow bins; how many are set apart.
    Span<uint32_t> fastCount() { return zeroed_.span().part(zeroed_.size() - 2, 1); }
    Span<uint32_t> apartCount() { return zeroed_.span().part(zeroed_.size() - 1, 1); }
    RowDrafts drafts() {
        return {rowCounts().part(0, counts_.in_bodies), draft_.span(), long_draft_.span(), kDraftLength,
                kLongDraftLength};
    }
    ProjectileBits projectileBits() {
        return {bits(), rowCounts().part(counts_.in_bodies, bit_words_), bit_words_ / shots()};
    }

    /// Rows up to this length are kept from the search; longer ones are searched twice.
    static constexpr uint32_t kDraftLength = 32, kLongDraftLength = 256;

    Backend& backend_;
    ParticleCounts counts_;
    NeighbourSettings settings_;
    double largest_radius_;      ///< m
    uint32_t mask_, bit_words_;  ///< buckets - 1; words of projectile bits
    double horizon_ = 0;
    uint64_t builds_ = 0;
    ContactArrays<Backend, Real> contacts_, former_;  ///< the lists, and those of the build before
    Buffer<VelocityRanges<Real>> ranges_;
    Buffer<GridFrame<Real>> frame_;
    Buffer<uint64_t> key_, member_key_;
    Buffer<SlowBins> slow_;
    Buffer<uint32_t> zeroed_, place_, member_, draft_, long_draft_;
    Buffer<uint32_t> bucket_start_;
    Buffer<uint32_t> sums_;  ///< of the row counts, their total, then the horizon for the host
    Buffer<uint32_t> buried_, place_kind_;
    Buffer<uint8_t> uncracked_;
    Buffer<uint64_t> sorted_entries_;
    Buffer<Vec4<Real>> member_ball_, member_position_, member_velocity_;
    typename Backend::Reader reader_;
};

template <class Backend, class Real>
NeighbourLists<Backend, Real>::NeighbourLists(Backend& backend, ParticleCounts counts, double largest_radius,
                                              const NeighbourSettings& settings)
    : backend_(backend),
      counts_(counts),
      settings_(settings),
      largest_radius_(largest_radius),
      mask_(std::bit_ceil(counts.in_bodies + 3) - 1),
      bit_words_(shots() * ((counts.total + kBitsPerWord - 1) / kBitsPerWord)),
      ranges_(backend.template allocate<VelocityRanges<Real>>(1)),
      frame_(backend.template allocate<GridFrame<Real>>(1)),
      key_(backend.template allocate<uint64_t>(counts.in_bodies)),
      member_key_(backend.template allocate<uint64_t>(counts.in_bodies)),
      slow_(backend.template allocate<SlowBins>(1)),
      zeroed_(backend.template allocate<uint32_t>(mask_ + 1 + counts.in_bodies + 2 * size_t{bit_words_} +
                                                  3 * kVelocityBins + 2)),
      place_(backend.template allocate<uint32_t>(counts.in_bodies)),
      member_(backend.template allocate<uint32_t>(counts.in_bodies)),
      draft_(backend.template allocate<uint32_t>(size_t{counts.in_bodies} * kDraftLength)),
      long_draft_(backend.template allocate<uint32_t>(size_t{kMostFast} * kLongDraftLength)),
      bucket_start_(backend.template allocate<uint32_t>(mask_ + size_t{2})),
      sums_(backend.template allocate<uint32_t>(counts.in_bodies + size_t{bit_words_} + 1 + kHorizonWords)),
      buried_(backend.template allocate<uint32_t>(counts.in_bodies)),
      place_kind_(backend.template allocate<uint32_t>(counts.in_bodies)),
      uncracked_(backend.template allocate<uint8_t>(counts.in_bodies)),
      sorted_entries_(backend.template allocate<uint64_t>(kMostInserted)),
      member_ball_(backend.template allocate<Vec4<Real>>(counts.in_bodies)),
      member_position_(backend.template allocate<Vec4<Real>>(counts.in_bodies)),
      member_velocity_(backend.template allocate<Vec4<Real>>(counts.in_bodies)),
      reader_(backend) {
    for (ContactArrays<Backend, Real>* lists : {&contacts_, &former_}) {
        lists->row_start = backend.template allocate<uint32_t>(counts.total + 1);
        lists->neighbour = backend.template allocate<uint32_t>(1);
        lists->spring = backend.template allocate<Vec4<Real>>(1);
    }
    contacts_.built_position = backend.template allocate<Vec4<Real>>(counts.total);
    contacts_.built_velocity = backend.template allocate<Vec4<Real>>(counts.total);
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::build(const StateIn<Real>& state,
                                          Span<const ParticleConstants<Real>> constants,
                                          const BondRowsIn<Real>& bonds) {
    exchangeRows();
    startPaths(state, constants, bonds);
    fillGrid();
    const NeighbourSearch<Real> search = searchOf(bonds);
    findPairs(search);
    writeRows(search);
    const std::vector<uint32_t>& told = reader_.wait();
    contacts_.used = told[0];
    horizon_ = std::bit_cast<double>(uint64_t{told[1]} | uint64_t{told[2]} << 32);
    if (contacts_.neighbour.size() < contacts_.used) {
        makeRoom();
        writeRows(search);
    }
    ++builds_;
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::startPaths(const StateIn<Real>& state,
                                               Span<const ParticleConstants<Real>> constants,
                                               const BondRowsIn<Real>& bonds) {
    backend_.fill(zeroed_.span(), 0u);
    backend_.forEach(counts_.in_bodies, MarkUncracked{enclosures(bonds), uncracked_.span()},
                     "mark uncracked");
    backend_.reduceInto(
        ranges_.span(), counts_.total, VelocityRanges<Real>{},
        StartPaths<Real>{state, constants, enclosures(bonds), uncracked_.view(),
                         contacts_.built_position.span(), contacts_.built_velocity.span(), place_kind_.span(),
                         Real(settings_.skin_share), Real(settings_.skin_share * largest_radius_),
                         Real(settings_.blind_time), Real(settings_.longest_horizon)},
        WidenRanges<Real>{}, "start paths");
    chooseFrame(state, constants);
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::chooseFrame(const StateIn<Real>& state,
                                                Span<const ParticleConstants<Real>> constants) {
    seekFast(state, constants);
    backend_.forEach(
        1,
        ChooseFrame<Real>{ranges_.view(), slow_.view(), fastCount(), frame_.span(),
                          sums_.span().part(sums_.size() - kHorizonWords, kHorizonWords),
                          2 * largest_radius_ * (1 + settings_.skin_share), settings_.travel_share,
                          settings_.longest_horizon, settings_.shot_travel},
        "choose frame");
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::seekFast(const StateIn<Real>& state,
                                             Span<const ParticleConstants<Real>> constants) {
    const uint32_t samples = (counts_.in_bodies + kSampleEvery - 1) / kSampleEvery;
    backend_.forEach(samples, SampleVelocities<Real>{state, constants, ranges_.view(), velocityBins()},
                     "sample velocities");
    backend_.forEach(3, TrimVelocities{velocityBins(), slow_.span(), samples}, "trim velocities");
    backend_.forEach(
        counts_.in_bodies,
        CountFast<Real>{state, constants, ranges_.view(), slow_.view(), place_kind_.view(), fastCount()},
        "count the fast");
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::fillGrid() {
    backend_.forEach(
        counts_.in_bodies,
        CountInBuckets<Real>{contacts_.paths(), frame_.view(), ranges_.view(), slow_.view(), mask_,
                             place_kind_.span(), key_.span(), bucketCounters(), apartCount(), place_.span()},
        "count in buckets");
    backend_.exclusiveScan(bucketCounters(), bucket_start_.span());
    backend_.forEach(counts_.in_bodies,
                     FillBuckets<Real>{contacts_.paths(),
                                       frame_.view(),
                                       key_.view(),
                                       bucket_start_.view(),
                                       place_.view(),
                                       place_kind_.view(),
                                       mask_,
                                       {member_.span(), member_key_.span(), member_ball_.span(),
                                        member_position_.span(), member_velocity_.span()}},
                     "fill buckets");
}

template <class Backend, class Real>
NeighbourSearch<Real> NeighbourLists<Backend, Real>::searchOf(const BondRowsIn<Real>& bonds) {
    return {contacts_.paths(),
            frame_.view(),
            key_.view(),
            bucket_start_.view(),
            {member_.view(), member_key_.view(), member_ball_.view(), member_position_.view(),
             member_velocity_.view()},
            bonds.row_start,
            bonds.link,
            place_kind_.view(),
            place_.view(),
            apartCount(),
            mask_,
            counts_.in_bodies,
            counts_.total};
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::insert(Span<const uint64_t> entries) {
    constexpr uint32_t kThreads = Backend::kOnGpu ? 8 : 1;
    const Span<uint64_t> sorted = sorted_entries_.span().part(0, entries.count);
    backend_.forEach(entries.count, SortEntries{entries, sorted, static_cast<uint32_t>(entries.count)},
                     "sort entries");
    exchangeRows();
    contacts_.used += static_cast<uint32_t>(entries.count);
    makeRoom();
    backend_.forEach(
        (size_t{counts_.total} + 1) * kThreads,
        CopyRowsWith<kThreads, Real>{formerRows(), sorted, contacts_.row_start.span(),
                                     contacts_.neighbour.span(), contacts_.spring.span(), counts_.total},
        "copy rows");
}

/// The total and the horizon are on their way to the host after this.
template <class Backend, class Real>
void NeighbourLists<Backend, Real>::findPairs(const NeighbourSearch<Real>& search) {
    PairFinder<Backend, Real>::find(backend_, search, drafts(), projectileBits());
    backend_.exclusiveScan(rowCounts(), sums_.span().part(0, rowCounts().count + 1));
    reader_.start(backend_, sums_.view().part(rowCounts().count, 1 + kHorizonWords));
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::makeRoom() {
    if (contacts_.neighbour.size() >= contacts_.used) return;
    backend_.synchronize();  // what was started before may still read them
    const size_t capacity = contacts_.used + contacts_.used / 2;
    contacts_.neighbour = backend_.template allocate<uint32_t>(capacity);
    contacts_.spring = backend_.template allocate<Vec4<Real>>(capacity);
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::writeRows(const NeighbourSearch<Real>& search) {
    constexpr uint32_t kThreads = Backend::kOnGpu ? 8 : 1;
    const RowWriter<Real> rows{formerRows(), sums_.view().part(0, rowCounts().count + 1),
                               contacts_.row_start.span(), contacts_.neighbour.span(),
                               contacts_.spring.span()};
    const uint32_t particle_threads = counts_.in_bodies * kThreads;
    backend_.forEach(
        particle_threads + size_t{bit_words_} * kBitsPerWord,
        WriteRows<kThreads, Real>{
            {search, rows, drafts()}, {rows, projectileBits(), counts_.in_bodies}, particle_threads},
        "write rows");
}

}  // namespace demolish
