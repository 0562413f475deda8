// SPDX-License-Identifier: Apache-2.0
// Triangles for a flat polygon with holes (geometry.md 2.4 g).
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace demolish {

struct PlanePoint {
    double x = 0, y = 0;
};

/// Twice the signed area of a, b, c: > 0 counter-clockwise.
inline double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Reused from face to face. Whatever the input, the triangles' border is that of the loops: where no proper
/// triangulation is found they may overlap, but nothing opens.
class FaceTriangulation {
  public:
    /// `loop_start`: loops of `points`, one past the end included; the first counter-clockwise, holes
    /// clockwise, at least three points each. Result: indices into `points`.
    const std::vector<std::array<uint32_t, 3>>& triangulate(std::span<const PlanePoint> points,
                                                            std::span<const uint32_t> loop_start);

  private:
    struct Node {
        uint32_t point, previous, next;
        double turn;
    };
    bool bridgeHole(uint32_t begin, uint32_t end, std::span<const uint32_t> loop_start);
    bool crossesLoops(uint32_t a, uint32_t b, std::span<const uint32_t> loop_start) const;
    bool isInWedge(uint32_t previous, uint32_t at, uint32_t next, uint32_t target) const;
    void clipEars();
    bool isEar(uint32_t node, int patience) const;
    void refreshTurn(uint32_t node);

    std::span<const PlanePoint> points_;
    double tolerance_ = 0;           // m^2, below it an area counts as nothing
    std::vector<uint32_t> outline_;  // points round the polygon, bridges walked both ways
    std::vector<Node> nodes_;
    std::vector<std::array<uint32_t, 3>> triangles_;
};

}  // namespace demolish
