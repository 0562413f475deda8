// Fragments: particles still joined by intact bonds (paper 3.2.1), and the particles in order of (fragment,
// id).
//
//   start labels -> join bonded -> flatten -> sort by label -> mark and measure rows
#pragma once
#include <bit>
#include <utility>
#include <vector>

#include "sim_cuda/data/particles.h"
#include "sim_cuda/kernels/fragment_sums.h"
#include "sim_cuda/kernels/join_bonded.h"
#include "sim_cuda/kernels/sort_by_key.h"

namespace demolish {

template <class Backend>
class Clustering {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Keeps a reference to the backend. Call update() before anything else.
    Clustering(Backend& backend, ParticleCounts counts);

    /// Call when bonds have broken. Does not wait for the device.
    void update(Span<const uint32_t> bond_row, Span<const BondLink> link);

    /// Of every particle: the lowest particle id of its fragment; a projectile slot is on its own.
    Span<const uint32_t> fragment() const { return label_.view(); }
    FragmentRows rows() const {
        return {order_.view(), label_.view().part(0, counts_.in_bodies), first_.view(), size_.view()};
    }

  private:
    void sortByLabel();

    Backend& backend_;
    ParticleCounts counts_;
    uint32_t chunks_;
    Buffer<uint32_t> label_, order_, sorted_, digit_start_, first_, size_;
};

template <class Backend>
Clustering<Backend>::Clustering(Backend& backend, ParticleCounts counts)
    : backend_(backend),
      counts_(counts),
      chunks_((counts.in_bodies + kSortChunk - 1) / kSortChunk),
      label_(backend.template allocate<uint32_t>(counts.total)),
      order_(backend.template allocate<uint32_t>(counts.in_bodies)),
      sorted_(backend.template allocate<uint32_t>(counts.in_bodies)),
      digit_start_(backend.template allocate<uint32_t>(kDigits * chunks_ + 1)),
      first_(backend.template allocate<uint32_t>(counts.in_bodies)),
      size_(backend.template allocate<uint32_t>(counts.in_bodies)) {}

template <class Backend>
void Clustering<Backend>::update(Span<const uint32_t> bond_row, Span<const BondLink> link) {
    backend_.forEach(counts_.total, StartLabels{label_.span()}, "start labels");
    backend_.forEach(counts_.in_bodies, JoinBonded{bond_row, link, label_.span()}, "join bonded");
    backend_.forEach(counts_.in_bodies, FlattenLabels{label_.span()}, "flatten labels");
    sortByLabel();
    backend_.fill(size_.span(), 0u);
    backend_.forEach(counts_.in_bodies, MarkFragments{order_.view(), label_.view(), first_.span()},
                     "mark fragments");
    backend_.forEach(counts_.in_bodies,
                     MeasureFragments{order_.view(), label_.view(), first_.view(), size_.span()},
                     "measure fragments");
}

template <class Backend>
void Clustering<Backend>::sortByLabel() {
    backend_.forEach(counts_.in_bodies, StartLabels{order_.span()}, "start order");
    const auto bits = static_cast<uint32_t>(std::bit_width(counts_.in_bodies));
    const Span<uint32_t> digit_count = digit_start_.span().part(0, kDigits * chunks_);
    for (uint32_t shift = 0; shift < bits; shift += kDigitBits) {
        backend_.forEach(chunks_, CountDigits{order_.view(), label_.view(), shift, chunks_, digit_count},
                         "count digits");
        backend_.exclusiveScan(digit_count, digit_start_.span());
        backend_.forEach(
            chunks_,
            PlaceDigits{order_.view(), label_.view(), digit_start_.view(), shift, chunks_, sorted_.span()},
            "place digits");
        std::swap(order_, sorted_);
    }
}

}  // namespace demolish
