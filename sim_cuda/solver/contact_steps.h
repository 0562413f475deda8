// SPDX-License-Identifier: Apache-2.0
// How a time of many substeps is divided into contact steps of rigid fragments.
#pragma once
#include <algorithm>
#include <cstdint>

#include "sim_cuda/physics/rigid_motion.h"

namespace demolish {

/// Steps of alike length: they differ by one substep at most. Where a step is longer than the one before it,
/// what presses changes its energy (physics B.1), by the more the more they differ.
class ContactSteps {
  public:
    /// Of so many substeps, 1 or more.
    explicit ContactSteps(uint32_t substeps)
        : substeps_(substeps),
          count_(std::max({1u, substeps / kRigidStride, (substeps + kLongest - 1) / kLongest})) {}

    uint32_t substeps() const { return substeps_; }
    uint32_t count() const { return count_; }
    /// The substep with which step k begins; where the last one ends for k = count().
    uint32_t start(uint32_t k) const { return static_cast<uint32_t>(uint64_t{k} * substeps_ / count_); }
    uint32_t length(uint32_t k) const { return start(k + 1) - start(k); }
    uint32_t longest() const { return (substeps_ + count_ - 1) / count_; }
    /// The step that substep `at` belongs to.
    uint32_t stepOf(uint32_t at) const {
        return static_cast<uint32_t>(((uint64_t{at} + 1) * count_ - 1) / substeps_);
    }
    /// Substeps from `at` until so many steps have ended, the one that it belongs to among them, or all.
    uint32_t untilEnd(uint32_t steps, uint32_t at) const {
        return start(std::min(stepOf(at) + steps, count_)) - at;
    }
    uint32_t lengthAt(uint32_t at) const { return length(stepOf(at)); }
    /// n substeps from `at` on, or fewer: until the last step that ends within them.
    uint32_t wholeWithin(uint32_t at, uint32_t n) const {
        return at + n >= substeps_ ? n : std::max(at, start(stepOf(at + n))) - at;
    }

  private:
    /// Substeps: multiples of kRigidStride have no other steps, and what is left of other numbers over is
    /// spread over them.
    static constexpr uint32_t kLongest = kRigidStride + 1;

    uint32_t substeps_, count_;
};

}  // namespace demolish
