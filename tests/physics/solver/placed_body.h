// SPDX-License-Identifier: Apache-2.0
// Bodies of the committed models, with the outsides that mortar and bodies against each other ask for.
#pragma once
#include <memory>
#include <string>

#include "sim_cuda/api/authoring.h"
#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {

/// `model`: a file of assets/models; `height`: m.
inline std::shared_ptr<const BreakableBody> filledModel(const std::string& model, double height,
                                                        uint32_t particles, uint64_t seed = 1) {
    const auto mesh = loadSolidMesh(DEMOLISH_SOURCE_DIR "/assets/models/" + model, {.height = height});
    return fillWithParticles(*mesh, {.particles = particles, .seed = seed});
}

/// Of brittleMaterial() without tough cells.
inline BodyInstance placedBody(std::shared_ptr<const BreakableBody> body, const Double3& position) {
    BodyInstance instance;
    instance.body = std::move(body);
    instance.position = position;
    instance.material = brittleMaterial();
    instance.material.tough_cells = 0;
    return instance;
}

}  // namespace demolish::tests
