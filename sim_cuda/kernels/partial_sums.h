// SPDX-License-Identifier: Apache-2.0
// The fixed order in which a particle's loads are added, on every device and for any number of threads.
#pragma once
#include "sim_cuda/kernels/own_particle.h"

namespace demolish {

/// Slot k of a row goes to partial sum k mod kPartials, contacts after bonds into the same ones, each in slot
/// order; then the tree l += l + m with m halving. A projectile's long row has kLongPartials.
inline constexpr uint32_t kPartials = 4, kLongPartials = 128;

template <uint32_t kCount, class Real>
class PartialSums {
  public:
    void add(uint32_t k, const Wrench<Real>& term) { demolish::add(sums_[k % kCount], term); }
    Wrench<Real> total() {
        for (uint32_t step = kCount / 2; step > 0; step /= 2)
            for (uint32_t l = 0; l < step; ++l) demolish::add(sums_[l], sums_[l + step]);
        return sums_[0];
    }

  private:
    Wrench<Real> sums_[kCount];
};

}  // namespace demolish
