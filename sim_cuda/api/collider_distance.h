// SPDX-License-Identifier: Apache-2.0
// Where there is room between colliders.
#pragma once
#include <span>

#include "sim_cuda/api/params.h"

namespace demolish {

/// m, from a point to the surface of the nearest collider; negative inside one. Infinite without any.
double colliderDistance(std::span<const Collider> colliders, const Double3& point);

}  // namespace demolish
