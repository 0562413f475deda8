// SPDX-License-Identifier: Apache-2.0
// How kernels see the static interior geometry of the scene, and the state of its faces.
#pragma once
#include "sim_cuda/api/fracture_geometry.h"
#include "sim_cuda/backend/span.h"
#include "sim_cuda/physics/vector.h"

namespace demolish {

/// State of an interior face, one byte each.
inline constexpr uint8_t kFaceHidden = 0, kFaceNew = 1, kFaceOld = 2;

/// Triangle corners at every pool vertex (rows of a CSR); see FractureGeometry.
struct PoolCorners {
    Span<const uint32_t> start, face, next, previous;
};

DEM_FN Vec3<float> toVec3(const Float3& p) {
    return {p.x, p.y, p.z};
}
DEM_FN Float3 toFloat3(const Vec3<float>& p) {
    return {p.x, p.y, p.z};
}

}  // namespace demolish
