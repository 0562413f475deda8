// SPDX-License-Identifier: Apache-2.0
// Rigid half spaces and the static friction that particles keep against each of them.
#pragma once
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/vec4.h"

namespace demolish {

inline constexpr uint32_t kMaxPlanes = 4;

/// Solid where dot(normal, x) < offset.
template <class Real>
struct PlaneSet {
    Vec4<Real> planes[kMaxPlanes];  ///< (unit normal, offset in m)
    uint32_t count = 0;
};

/// Spring of particle i against plane p: element p * total + i.
template <class Backend, class Real>
struct PlaneArrays {
    typename Backend::template Buffer<Vec4<Real>>
        spring;  ///< (tangential spring seen from the particle, m; 0)
};

}  // namespace demolish
