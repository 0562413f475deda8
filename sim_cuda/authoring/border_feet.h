// SPDX-License-Identifier: Apache-2.0
// Points on the borders of tough cells, evenly spread: each becomes the foot of a mirrored pair of seeds.
#pragma once
#include <optional>
#include <vector>

#include "sim_cuda/authoring/mesh_queries.h"
#include "sim_cuda/authoring/spacing_field.h"
#include "sim_cuda/authoring/tough_field.h"

namespace demolish {

struct BorderFoot {
    Double3 at;             ///< m, on the border
    uint32_t a = 0, b = 0;  ///< the tough cells that meet there
    Double3 normal;         ///< unit, towards a
};

/// What borders are asked for.
class ToughBorders {
  public:
    ToughBorders(const ToughField& field, const DistanceGrid& grid, const SpacingField& spacing)
        : field_(field), grid_(grid), spacing_(spacing) {}

    /// The foot on the border of a and b near x; none where a third cell is near, or the surface.
    std::optional<BorderFoot> footNear(const Double3& x, uint32_t a, uint32_t b) const;
    double spacingAt(const Double3& x) const { return spacing_.at(x); }
    const SpacingField& spacing() const { return spacing_; }
    const ToughField& field() const { return field_; }
    const DistanceGrid& grid() const { return grid_; }

  private:
    bool isClear(const BorderFoot& foot) const;

    const ToughField& field_;
    const DistanceGrid& grid_;
    const SpacingField& spacing_;
};

/// As many as there is room for, not nearer to each other than 0.85 spacings; the same for any number of
/// threads.
std::vector<BorderFoot> spreadFeet(const ToughBorders& borders, const std::vector<Double3>& seeds,
                                   uint64_t random);

}  // namespace demolish
