// SPDX-License-Identifier: Apache-2.0
// A convex polyhedron that planes cut, in the dual form: a vertex is three planes (geometry.md 2.2).
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

/// Everything is relative to the seed, which stays inside. Reused from cell to cell, so that nothing is
/// allocated in the long run.
class ConvexCell {
  public:
    struct Plane {
        Double3 normal;      ///< outward, not normalised
        double offset = 0;   ///< inside: normal . p <= offset
        uint32_t neighbour;  ///< kNoCell for a plane of the start cube
    };
    struct Vertex {
        std::array<uint16_t, 3> planes;  ///< counter-clockwise seen from outside
        Double3 position;                ///< m
    };

    /// Starts anew with a cube of the given half side (m).
    void reset(double half_side);

    /// Cuts off what is nearer to the seed at `towards` (m, relative) than to this one.
    void cut(const Double3& towards, uint32_t neighbour);

    /// m, distance of the farthest vertex; never more than that of the cube's corners.
    double reach() const { return reach_; }

    const std::vector<Plane>& planes() const { return planes_; }
    const std::vector<Vertex>& vertices() const { return vertices_; }

  private:
    Vertex makeVertex(uint16_t a, uint16_t b, uint16_t c) const;
    void collectBorder(const std::array<uint16_t, 3>& removed);

    std::vector<Plane> planes_;
    std::vector<Vertex> vertices_;
    std::vector<std::array<uint16_t, 2>> border_;  // directed edges round the removed patch
    double reach_ = 0, most_reach_ = 0;
};

}  // namespace demolish
