// Contact lists: which pairs may touch for a while, found on the paper's uniform grid (3.3.1).
//
//   start paths -> common velocity, horizon -> count in buckets -> scan -> fill buckets
//               -> count rows -> scan -> write rows sorted, with the springs of the rows before
//
// Soundness: kernels/predicted_path.h. Everything is counted in whole numbers and every choice is made on
// equal bits, so the rows are the same on every device and for any number of threads.
#pragma once
#include <bit>
#include <cmath>
#include <utility>

#include "sim_cuda/data/bonds.h"
#include "sim_cuda/kernels/fill_grid.h"
#include "sim_cuda/kernels/find_projectile_rows.h"
#include "sim_cuda/kernels/start_paths.h"
#include "sim_cuda/solver/velocity_range.h"

namespace demolish {

struct NeighbourSettings {
    double skin_share = 0.5;     ///< skin of a particle over its R_c, 0.1..1: wider lists, fewer builds
    double travel_share = 1;     ///< largest travel within a horizon over the largest reach of two particles
    double longest_horizon = 1;  ///< s, at rest
};

template <class Backend, class Real>
class NeighbourLists {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Lists are empty before the first build. `largest_radius`: of R_c among the bodies' particles, m, > 0.
    NeighbourLists(Backend& backend, ParticleCounts counts, double largest_radius,
                   const NeighbourSettings& settings = {});

    /// Builds the rows from the present state. Waits for the device. Needed at the start, when
    /// elapsed + lookahead passes horizon(), when CheckPaths says so, and when a projectile starts.
    void build(const StateIn<Real>& state, Span<const Vec4<Real>> constants, const BondRowsIn<Real>& bonds);

    /// Makes room for `used` entries that the caller writes (a state put back) and takes over their horizon
    /// (s).
    void adopt(uint32_t used, double horizon) {
        horizon_ = horizon;
        contacts_.used = used;
        makeRoom();
    }

    /// s after the last build.
    double horizon() const { return horizon_; }
    /// Builds so far.
    uint64_t builds() const { return builds_; }

    ContactArrays<Backend, Real>& contacts() { return contacts_; }
    const ContactArrays<Backend, Real>& contacts() const { return contacts_; }

  private:
    void chooseFrame();
    void fillGrid();
    void countRows(const NeighbourSearch<Real>& search);
    void writeRows(const NeighbourSearch<Real>& search);
    void makeRoom();
    NeighbourSearch<Real> searchOf(const BondRowsIn<Real>& bonds) const;

    Backend& backend_;
    ParticleCounts counts_;
    NeighbourSettings settings_;
    double reach_;  ///< m, of two particles of the largest radius
    double largest_skin_;
    uint32_t mask_, chunks_;
    double horizon_ = 0;
    uint64_t builds_ = 0;
    GridFrame<Real> frame_;
    ContactArrays<Backend, Real> contacts_, former_;  ///< the lists, and those of the build before
    Buffer<uint64_t> key_;
    Buffer<uint32_t> bucket_start_, place_, member_, draft_, count_, chunk_start_;
    Buffer<Vec4<Real>> member_position_, member_velocity_;
};

template <class Backend, class Real>
NeighbourLists<Backend, Real>::NeighbourLists(Backend& backend, ParticleCounts counts, double largest_radius,
                                              const NeighbourSettings& settings)
    : backend_(backend),
      counts_(counts),
      settings_(settings),
      reach_(2 * largest_radius * (1 + settings.skin_share)),
      largest_skin_(settings.skin_share * largest_radius),
      mask_(std::bit_ceil(2 * counts.in_bodies + 1) - 1),
      chunks_((counts.total + kProjectileChunk - 1) / kProjectileChunk),
      key_(backend.template allocate<uint64_t>(counts.in_bodies)),
      bucket_start_(backend.template allocate<uint32_t>(mask_ + 2)),
      place_(backend.template allocate<uint32_t>(counts.in_bodies)),
      member_(backend.template allocate<uint32_t>(counts.in_bodies)),
      draft_(backend.template allocate<uint32_t>(size_t{counts.in_bodies} * kDraftLength)),
      count_(backend.template allocate<uint32_t>(counts.total)),
      chunk_start_(backend.template allocate<uint32_t>((counts.total - counts.in_bodies) * chunks_ + 1)),
      member_position_(backend.template allocate<Vec4<Real>>(counts.in_bodies)),
      member_velocity_(backend.template allocate<Vec4<Real>>(counts.in_bodies)) {
    for (ContactArrays<Backend, Real>* lists : {&contacts_, &former_}) {
        lists->row_start = backend.template allocate<uint32_t>(counts.total + 1);
        lists->neighbour = backend.template allocate<uint32_t>(1);
        lists->spring = backend.template allocate<Vec4<Real>>(1);
    }
    contacts_.built_position = backend.template allocate<Vec4<Real>>(counts.total);
    contacts_.built_velocity = backend.template allocate<Vec4<Real>>(counts.total);
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::build(const StateIn<Real>& state, Span<const Vec4<Real>> constants,
                                          const BondRowsIn<Real>& bonds) {
    std::swap(contacts_.row_start, former_.row_start);
    std::swap(contacts_.neighbour, former_.neighbour);
    std::swap(contacts_.spring, former_.spring);
    backend_.forEach(
        counts_.total,
        StartPaths<Real>{state, constants, contacts_.built_position.span(), contacts_.built_velocity.span(),
                         Real(settings_.skin_share), Real(largest_skin_)},
        "start paths");
    chooseFrame();
    fillGrid();
    const NeighbourSearch<Real> search = searchOf(bonds);
    countRows(search);
    writeRows(search);
    ++builds_;
}

/// The horizon is as long as the grid's cells allow: travel_share of the reach for the fastest particle, seen
/// from the middle of all velocities, and four reaches for the fastest projectile.
template <class Backend, class Real>
void NeighbourLists<Backend, Real>::chooseFrame() {
    const VelocityRanges<Real> ranges =
        backend_.reduce(counts_.total, VelocityRanges<Real>{},
                        VelocityOfPath<Real>{contacts_.built_velocity.view(), counts_.in_bodies},
                        WidenRanges<Real>{}, "velocity ranges");
    frame_.common_velocity = middleOf(ranges.bodies);
    const double spread = largestSpeed(ranges.bodies, frame_.common_velocity);
    const double shot_speed = largestSpeed(ranges.projectiles, frame_.common_velocity);
    horizon_ = settings_.longest_horizon;
    if (spread * horizon_ > settings_.travel_share * reach_)
        horizon_ = settings_.travel_share * reach_ / spread;
    if (shot_speed * horizon_ > 4 * reach_) horizon_ = 4 * reach_ / shot_speed;
    horizon_ = static_cast<double>(static_cast<Real>(horizon_));
    // 2 %: round-off of positions far from the origin (up to 5e4 cells in float).
    frame_.inverse_cell = static_cast<Real>(1 / (1.02 * (reach_ + spread * horizon_)));
    frame_.half_horizon = static_cast<Real>(0.5 * horizon_);
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::fillGrid() {
    const uint32_t n = counts_.in_bodies;
    const Span<uint32_t> counter = bucket_start_.span().part(0, mask_ + 1);
    backend_.fill(counter, 0u);
    backend_.forEach(
        n, CountInBuckets<Real>{contacts_.paths(), frame_, mask_, key_.span(), counter, place_.span()},
        "count in buckets");
    backend_.exclusiveScan(counter, bucket_start_.span());
    backend_.forEach(
        n,
        FillBuckets<Real>{contacts_.paths(), key_.view(), bucket_start_.view(), place_.view(), mask_,
                          member_.span(), member_position_.span(), member_velocity_.span()},
        "fill buckets");
}

template <class Backend, class Real>
NeighbourSearch<Real> NeighbourLists<Backend, Real>::searchOf(const BondRowsIn<Real>& bonds) const {
    return {contacts_.paths(),       key_.view(),
            bucket_start_.view(),    member_.view(),
            member_position_.view(), member_velocity_.view(),
            bonds.row_start,         bonds.link,
            Real(horizon_),          mask_,
            counts_.in_bodies,       counts_.total};
}

template <class Backend, class Real>
void NeighbourLists<Backend, Real>::countRows(const NeighbourSearch<Real>& search) {
    const uint32_t shots = counts_.total - counts_.in_bodies;
    const Span<uint32_t> chunk_count = chunk_start_.span().part(0, shots * chunks_);
    backend_.forEach(counts_.in_bodies, CountNeighbours<Real>{search, count_.span(), draft_.span()},
                     "count neighbours");
    backend_.forEach(shots * chunks_, CountProjectileChunks<Real>{{search, chunks_}, chunk_count},
                     "count projectile chunks");
    backend_.exclusiveScan(chunk_count, chunk_start_.span());
    backend_.forEach(shots,
                     CountProjectileRows{chunk_start_.view(), chunks_, counts_.in_bodies, count_.span()},
                     "count projectile rows");
    backend_.exclusiveScan(count_.view(), contacts_.row_start.span());
    backend_.download(contacts_.row_start.view().part(counts_.total, 1), &contacts_.used);
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
    makeRoom();
    const FormerRows<Real> former{former_.row_start.view(), former_.neighbour.view(), former_.spring.view()};
    backend_.forEach(counts_.in_bodies,
                     WriteNeighbours<Real>{search, former, contacts_.row_start.view(), draft_.view(),
                                           contacts_.neighbour.span(), contacts_.spring.span()},
                     "write neighbours");
    backend_.forEach((counts_.total - counts_.in_bodies) * chunks_,
                     WriteProjectileRows<Real>{{search, chunks_},
                                               former,
                                               chunk_start_.view(),
                                               contacts_.row_start.view(),
                                               contacts_.neighbour.span(),
                                               contacts_.spring.span()},
                     "write projectile rows");
}

}  // namespace demolish
