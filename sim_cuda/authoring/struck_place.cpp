// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/struck_place.h"

#include <cmath>

#include "sim_cuda/authoring/double3.h"

namespace demolish {
namespace {

/// Of the places near a height, at that height.
Double3 middleAt(double height, const std::vector<Double3>& places, double reach) {
    Double3 sum;
    double count = 0;
    for (const Double3& place : places) {
        if (std::fabs(place.y - height) > reach) continue;
        sum += place;
        ++count;
    }
    return count > 0 ? Double3{sum.x / count, height, sum.z / count} : Double3{0, height, 0};
}

}  // namespace

Double3 struckPlace(const ShotAim& aim, const std::vector<Double3>& places, double reach) {
    const Double3 way = normalized(aim.way),
                  through = aim.through ? *aim.through : middleAt(aim.height, places, reach);
    Double3 first, nearest;
    double earliest = 1e300, least = 1e300;
    for (const Double3& place : places) {
        const Double3 from = place - through;
        const double along = dot(from, way), aside = lengthSquared(from - along * way);
        if ((aim.is_wall || aside <= reach * reach) && along < earliest) {
            earliest = along;
            first = place;
        }
        if (aside < least) {
            least = aside;
            nearest = place;
        }
    }
    return earliest < 1e300 ? first : nearest;
}

}  // namespace demolish
