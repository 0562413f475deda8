// SPDX-License-Identifier: Apache-2.0
// The nearest surface points of a few layers of the distance grid, triangle by triangle.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "sim_cuda/authoring/distance_field.h"

namespace demolish {

inline constexpr double kBand =
    1.8;  // steps; above the diagonal of a grid cell, so every cell the surface meets is exact
inline constexpr int kSlabLayers = 4;

/// Nearest surface point known so far, relative to the grid's origin.
struct Nearest {
    float x = 0, y = 0, z = 0, squared = std::numeric_limits<float>::infinity();
};

struct IndexRange {
    int begin, end;
    bool isEmpty() const { return begin >= end; }
};
/// Nodes along one axis whose coordinate (relative to the origin) lies in [lower, upper].
inline IndexRange nodesBetween(double lower, double upper, double step, int count) {
    const double last = count - 1;
    return {int(std::clamp(std::ceil(lower / step), 0.0, double(count))),
            int(std::clamp(std::floor(upper / step), -1.0, last)) + 1};
}

struct SplatTriangle;

/// Layers [begin, end) of the grid. Knows of blocks of nodes how far their nearest points are at most: where
/// many triangles crowd, most of them come too late for most of the nodes that they are near.
class SlabSplat {
  public:
    SlabSplat(const NodeFrame& frame, IndexRange layers, std::vector<Nearest>& nearest);

    /// Corners are relative to the grid's origin. Of equally near triangles the first is kept.
    void add(const std::array<Double3, 3>& corners);

  private:
    static constexpr int kBlock = 8;  // nodes along x and y

    struct Ranges {
        IndexRange x, y, z;
    };
    void splatBlock(const SplatTriangle& triangle, const Ranges& nodes, double reach);
    void splatRow(const SplatTriangle& triangle, IndexRange nodes, int j, int k);
    void lookAtBlocks();

    NodeFrame frame_;
    IndexRange layers_;
    std::vector<Nearest>& nearest_;
    int blocks_x_, blocks_y_;
    std::vector<double> reach_;  // m, by block: no node takes a point from farther away; infinite: unknown
    int since_look_ = 0;         // triangles
};

}  // namespace demolish
