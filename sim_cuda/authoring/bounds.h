// SPDX-License-Identifier: Apache-2.0
// The box about some points, along the axes.
#pragma once
#include <vector>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

/// m
struct Bounds {
    Double3 lower, upper;
    Double3 size() const { return upper - lower; }
    void add(const std::vector<Double3>& points) {
        for (const Double3& p : points) {
            lower = minimum(lower, p);
            upper = maximum(upper, p);
        }
    }
};

/// Of at least one point.
inline Bounds boundsOf(const std::vector<Double3>& points) {
    Bounds bounds{points.front(), points.front()};
    bounds.add(points);
    return bounds;
}

}  // namespace demolish
