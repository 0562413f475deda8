// SPDX-License-Identifier: Apache-2.0
// Sizes by a power law: N(> s) ~ s^-e between two ends, as a table of quantiles, since kernels have no
// powers.
#pragma once
#include <cmath>
#include <vector>

#include "sim_cuda/backend/span.h"
#include "sim_cuda/physics/scalar.h"

namespace demolish {

inline constexpr uint32_t kQuantiles = 1024;

/// The size that a share u (0..1) of all exceeds. The large ones are few and
/// far apart: the table is even in the root of u, so that it is fine among them.
DEM_FN float sizeAt(const Span<const float>& quantile, float u) {
    const float place = static_cast<float>(kQuantiles - 1) * squareRoot(u);
    const auto below = static_cast<uint32_t>(place);
    const uint32_t above = below + 1 < kQuantiles ? below + 1 : below;
    const float part = place - static_cast<float>(below);
    return madd(part, quantile[above] - quantile[below], quantile[below]);
}

/// least < most, in any unit; element k belongs to u = (k / (kQuantiles - 1))^2.
inline std::vector<float> sizeQuantiles(double least, double most, double exponent) {
    const double all = std::pow(least, -exponent), none = std::pow(most, -exponent);
    std::vector<float> quantile(kQuantiles);
    for (uint32_t k = 0; k < kQuantiles; ++k) {
        const double root = static_cast<double>(k) / (kQuantiles - 1), larger = root * root;
        quantile[k] = static_cast<float>(std::pow(none + (all - none) * larger, -1 / exponent));
    }
    return quantile;
}

}  // namespace demolish
