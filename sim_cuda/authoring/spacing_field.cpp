// SPDX-License-Identifier: Apache-2.0
// N = integral of dV / s^3 fixes the finest spacing.
#include "sim_cuda/authoring/spacing_field.h"

#include <algorithm>
#include <cmath>

namespace demolish {

SpacingField::SpacingField(double factor, const Double3& aim, double reach, double cell_volume,
                           const DistanceGrid& grid)
    : finest_(1), factor_(factor), reach_(reach), aim_(aim), grid_(&grid) {
    const std::vector<Double3>& nodes = grid.insideNodesInMortonOrder();
    double cells = 0;  // of the finest volume, in the volume of a node
    for (const Double3& node : nodes) cells += 1 / (share(node) * share(node) * share(node));
    finest_ = std::cbrt(cell_volume * cells / static_cast<double>(nodes.size()));
}

double SpacingField::share(const Double3& x) const {
    if (isEven()) return 1;
    const double far = length(x - aim_) + std::max(0.0, -grid_->distance(x));
    return 1 + (factor_ - 1) * std::min(1.0, far / reach_);
}

}  // namespace demolish
