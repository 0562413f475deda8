// SPDX-License-Identifier: Apache-2.0
// Fragments: particles still joined by intact bonds (paper 3.2.1), and the particles in order of (fragment,
// id).
//
//   start labels at the lowest bonded neighbour -> flatten -> join bonded -> flatten -> order by label
//   -> mark and measure rows
#pragma once
#include "sim_cuda/data/particles.h"
#include "sim_cuda/kernels/fragment_sums.h"
#include "sim_cuda/kernels/join_bonded.h"

namespace demolish {

template <class Backend>
class Clustering {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Keeps a reference to the backend. Call update() before anything else.
    Clustering(Backend& backend, ParticleCounts counts);

    /// Call when bonds have broken. owner: of each particle, so that only those of one body are joined; none:
    /// all are. Does not wait for the device.
    void update(Span<const uint32_t> bond_row, Span<const BondLink> link, Span<const uint32_t> owner = {});

    /// Of every particle: the lowest particle id of its fragment; a projectile slot is on its own.
    Span<const uint32_t> fragment() const { return label_.view(); }
    FragmentRows rows() const {
        return {order_.view(), label_.view().part(0, counts_.in_bodies), first_.view(), size_.view()};
    }

  private:
    Backend& backend_;
    ParticleCounts counts_;
    Buffer<uint32_t> label_, order_, first_, size_;
};

template <class Backend>
Clustering<Backend>::Clustering(Backend& backend, ParticleCounts counts)
    : backend_(backend),
      counts_(counts),
      label_(backend.template allocate<uint32_t>(counts.total)),
      order_(backend.template allocate<uint32_t>(counts.in_bodies)),
      first_(backend.template allocate<uint32_t>(counts.in_bodies)),
      size_(backend.template allocate<uint32_t>(counts.in_bodies)) {}

template <class Backend>
void Clustering<Backend>::update(Span<const uint32_t> bond_row, Span<const BondLink> link,
                                 Span<const uint32_t> owner) {
    const Span<uint32_t> label = label_.span();
    backend_.forEach(counts_.total, StartLabels{bond_row, link, label, counts_.in_bodies, owner},
                     "start labels");
    backend_.forEach(counts_.in_bodies, FlattenLabels{label}, "flatten labels");
    constexpr uint32_t kThreads = Backend::kOnGpu ? 4 : 1;
    backend_.forEach(size_t{counts_.in_bodies} * kThreads, JoinBonded<kThreads>{bond_row, link, label, owner},
                     "join bonded");
    backend_.forEach(counts_.in_bodies, FlattenLabels{label}, "flatten labels");
    backend_.orderByKey(label_.view().part(0, counts_.in_bodies), order_.span());
    backend_.fill(size_.span(), 0u);
    backend_.forEach(counts_.in_bodies, MarkFragments{order_.view(), label_.view(), first_.span()},
                     "mark fragments");
    backend_.forEach(counts_.in_bodies,
                     MeasureFragments{order_.view(), label_.view(), first_.view(), size_.span()},
                     "measure fragments");
}

}  // namespace demolish
