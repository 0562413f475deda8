// SPDX-License-Identifier: Apache-2.0
// Bodies as authoring makes them, for measurements of whole bodies: boxes, spheres and the models of the
// assets.
#pragma once
#include <memory>
#include <string>

#include "sim_cuda/api/solver.h"

namespace demolish::tests {

/// Box of these sides (m), centred in x and z, standing on y = 0.
std::shared_ptr<const BreakableBody> boxBody(const Double3& sides, uint32_t particles, uint64_t seed);
/// Ball of this diameter (m), standing on y = 0.
std::shared_ptr<const BreakableBody> sphereBody(double diameter, uint32_t particles, uint64_t seed);
/// assets/models/NAME.obj, this tall (m).
std::shared_ptr<const BreakableBody> modelBody(const std::string& name, double height, uint32_t particles,
                                               uint64_t seed);

}  // namespace demolish::tests
