// SPDX-License-Identifier: Apache-2.0
// Tough cells (models E.3) as a function of the place at rest, so that a packing can follow their borders.
#pragma once
#include <memory>
#include <vector>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/authoring/double3.h"

namespace demolish {

/// May be asked by any number of threads.
class ToughField {
  public:
    virtual ~ToughField() = default;

    /// A word for the tough cell that holds the place (m).
    virtual uint32_t cellAt(const Double3& x) const = 0;
    /// Above 0 on a's side of the border between two neighbours, below on b's, and smooth across it; of
    /// whatever unit.
    virtual double side(const Double3& x, uint32_t a, uint32_t b) const = 0;
};

/// `centre` (m): of the pattern. `seeds` (m): a relaxed packing of the body; `volume` m^3, `spacing` m. Null
/// where all is one tough cell, each particle one of its own, or there is none.
std::unique_ptr<const ToughField> makeToughField(const ToughCellOptions& options, const Double3& centre,
                                                 const std::vector<Double3>& seeds, double volume,
                                                 double spacing, uint64_t seed);

/// Gradient of side(), by differences over `reach` m.
Double3 borderGradient(const ToughField& field, const Double3& x, uint32_t a, uint32_t b, double reach);

}  // namespace demolish
