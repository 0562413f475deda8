// SPDX-License-Identifier: Apache-2.0
// What a shot left: the pieces by mass, as the sheets count them (models.md E.2, E.3).
#pragma once
#include <vector>

#include "sim_cuda/api/solver.h"

namespace demolish::tests {

struct Pieces {
    double largest = 1;   ///< share of the mass
    uint32_t big = 0;     ///< of at least 1 % of the mass
    uint32_t solid = 0;   ///< of at least 3 particles
    double dust = 0;      ///< share of the mass in pieces of one or two particles
    uint32_t moving = 0;  ///< pieces whose fastest particle exceeds 2 cm/s
    bool broken() const { return largest < 0.8 && big >= 2; }
};

/// Of the first body. Speeds follow from where the particles were at the look before.
class PieceCounter {
  public:
    explicit PieceCounter(const SceneSetup& setup);
    /// Looks at the solver's present frame; `seconds` since the look before, for the speeds (0: not wanted).
    Pieces count(Solver& solver, double seconds = 0);

  private:
    std::vector<double> mass_;
    std::vector<uint32_t> fragment_;
    std::vector<ParticleInstance> shown_, before_;
};

}  // namespace demolish::tests
