// SPDX-License-Identifier: Apache-2.0
// The same distances that contacts go by.
#include "sim_cuda/api/collider_distance.h"

#include <limits>

#include "sim_cuda/data/colliders.h"

namespace demolish {

double colliderDistance(std::span<const Collider> colliders, const Double3& point) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto set = makeColliderSet<double>({colliders.begin(), colliders.end()});
    forEachCollider(set, {point.x, point.y, point.z}, [&](uint32_t, const TangentPlane<double>& tangent) {
        nearest = minOf(nearest, tangent.distance);
    });
    return nearest;
}

}  // namespace demolish
