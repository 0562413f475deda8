// SPDX-License-Identifier: Apache-2.0
// Things that stand on, lean against or lie beside each other at the start touch with their outsides there,
// not with the spheres in their cells.
#pragma once
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

/// Adds a record (PairState::kFacing) for each two cells of different bodies that lie against each other and
/// that no mortar joins: they touch at the distance at which their outsides do. After all that is worked out
/// from bonds.
void letBodiesFace(const SceneSetup& setup, SceneTables& tables);

}  // namespace demolish
