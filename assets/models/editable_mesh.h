// SPDX-License-Identifier: Apache-2.0
// A closed surface whose edges can be collapsed one by one, with the tests that say which may.
#pragma once
#include <vector>

#include "assets/models/surface.h"

namespace demolish::sculptor {

/// How far one collapse may change the triangles around it.
struct ShapeLimits {
    double turn_cosine = 0.3;  ///< least cosine between a triangle's normal before and after
    double quality = 0.15;  ///< least 4 sqrt(3) area / (sum of squared sides): 1 equilateral, 0 without area
};

class EditableMesh {
  public:
    explicit EditableMesh(const Surface& surface);

    std::size_t triangleCount() const { return alive_count_; }
    std::size_t vertexCount() const { return positions_.size(); }
    bool isAlive(std::uint32_t vertex) const { return !fans_[vertex].empty(); }
    Vec3 position(std::uint32_t vertex) const { return positions_[vertex]; }

    /// Vertices that share an edge with `vertex`, rising.
    std::vector<std::uint32_t> neighbours(std::uint32_t vertex) const;

    /// Link condition: a and b share exactly the two vertices opposite their edge, and no part shrinks to
    /// less than a tetrahedron. Then the collapse keeps the surface closed, manifold and of the same genus.
    bool keepsManifold(std::uint32_t a, std::uint32_t b) const;

    /// True when no surviving triangle turns, folds or thins beyond the limits with a and b both at `p`. A
    /// triangle that was thin already may stay as thin as it was.
    bool keepsShape(std::uint32_t a, std::uint32_t b, Vec3 p, const ShapeLimits& limits) const;

    /// Moves a to `p` and merges b into it; removes two triangles. Both tests must have passed.
    void collapse(std::uint32_t a, std::uint32_t b, Vec3 p);

    /// What is left, in the original order.
    Surface surface() const;

  private:
    bool fanKeepsShape(std::uint32_t moved, std::uint32_t other, Vec3 p, const ShapeLimits& limits) const;

    std::vector<Vec3> positions_;
    std::vector<Triangle> triangles_;
    std::vector<bool> alive_;
    std::vector<std::vector<std::uint32_t>> fans_;  ///< triangles around each vertex; empty: merged away
    std::size_t alive_count_ = 0;
};

}  // namespace demolish::sculptor
