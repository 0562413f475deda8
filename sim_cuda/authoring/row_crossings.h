// SPDX-License-Identifier: Apache-2.0
// Winding numbers of all grid nodes at once: signed crossings of the surface along the grid's rows.
#pragma once
#include <array>
#include <vector>

#include "sim_cuda/authoring/distance_field.h"

namespace demolish {

/// Layers (z) are independent: tasks may work on different ones at the same time.
class RowCrossings {
  public:
    explicit RowCrossings(const NodeFrame& frame);

    /// Adds a triangle (corners relative to the grid's origin) to the rows of layers [begin, end).
    void add(const std::array<Double3, 3>& corners, int layer_begin, int layer_end);
    /// Turns crossings into winding numbers once all triangles of these layers are in. Rows that graze an
    /// edge are asked of `windingAt(i, j, k)` node by node.
    template <typename WindingAt>
    void finishLayers(int layer_begin, int layer_end, WindingAt&& windingAt) {
        for (int k = layer_begin; k < layer_end; ++k)
            for (int j = 0; j < frame_.ny; ++j) {
                int16_t* row = winding_.data() + frame_.index(0, j, k);
                if (is_grazed_[size_t(k) * size_t(frame_.ny) + size_t(j)] != 0) {
                    for (int i = 0; i < frame_.nx; ++i) row[i] = int16_t(windingAt(i, j, k));
                    continue;
                }
                for (int i = frame_.nx - 2; i >= 0; --i) row[i] = int16_t(row[i] + row[i + 1]);
            }
    }
    int winding(size_t node) const { return winding_[node]; }

  private:
    void addRow(const std::array<Double3, 3>& corners, int j, int k);

    NodeFrame frame_;
    std::vector<int16_t> winding_;    // until finished: crossings just beyond each node
    std::vector<uint8_t> is_grazed_;  // by row
};

}  // namespace demolish
