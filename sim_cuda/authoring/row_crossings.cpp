// SPDX-License-Identifier: Apache-2.0
// Counts crossings row by row.
#include "sim_cuda/authoring/row_crossings.h"

#include "sim_cuda/authoring/planar_side.h"

namespace demolish {

RowCrossings::RowCrossings(const NodeFrame& frame)
    : frame_(frame), winding_(frame.size()), is_grazed_(size_t(frame.ny) * size_t(frame.nz)) {}

void RowCrossings::add(const std::array<Double3, 3>& corners, int layer_begin, int layer_end) {
    const auto& [a, b, c] = corners;
    const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
    const auto [z_low, z_high] = std::minmax({a.z, b.z, c.z});
    const int k_begin = std::max(layer_begin, int(std::floor(z_low / frame_.step)));
    const int k_end = std::min(layer_end, int(std::ceil(z_high / frame_.step)) + 1);
    const int j_begin = std::max(0, int(std::floor(y_low / frame_.step)));
    const int j_end = std::min(frame_.ny, int(std::ceil(y_high / frame_.step)) + 1);
    for (int k = k_begin; k < k_end; ++k)
        for (int j = j_begin; j < j_end; ++j) addRow(corners, j, k);
}

void RowCrossings::addRow(const std::array<Double3, 3>& corners, int j, int k) {
    const double y = j * frame_.step, z = k * frame_.step;
    const auto& [a, b, c] = corners;
    const double u = edgeSide(b.y - y, b.z - z, c.y - y, c.z - z);
    const double v = edgeSide(c.y - y, c.z - z, a.y - y, a.z - z);
    const double w = edgeSide(a.y - y, a.z - z, b.y - y, b.z - z);
    if ((u > 0 || v > 0 || w > 0) && (u < 0 || v < 0 || w < 0)) return;
    if (u == 0 || v == 0 || w == 0) {
        is_grazed_[size_t(k) * size_t(frame_.ny) + size_t(j)] = 1;
        return;
    }
    const double x = (u * a.x + v * b.x + w * c.x) / (u + v + w);
    const int before =
        std::min(frame_.nx, int(std::ceil(x / frame_.step)));  // nodes that see the crossing ahead
    if (before > 0) winding_[frame_.index(before - 1, j, k)] += int16_t(u > 0 ? 1 : -1);
}

}  // namespace demolish
