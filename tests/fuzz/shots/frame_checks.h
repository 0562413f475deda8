// SPDX-License-Identifier: Apache-2.0
// What must hold of a body that was made, and of every frame that is exported.
#pragma once
#include <string>
#include <vector>

#include "app/session/built_shot.h"

namespace demolish::fuzz {

/// Cells against the mesh, mass against density and volume, particles against what was asked for: one
/// sentence a fault.
std::vector<std::string> faultsOfBody(const BuiltShot& built);

/// Reads all streams of the solver's present frame, from either device: numbers that are not finite, indices
/// beyond their vertices. `colour` is what the particle view is coloured by.
std::vector<std::string> faultsOfFrame(const BuiltShot& built, uint32_t projectiles, ParticleColour colour);

}  // namespace demolish::fuzz
