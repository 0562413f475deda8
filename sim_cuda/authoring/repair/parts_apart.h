// SPDX-License-Identifier: Apache-2.0
// Parts that touch get surfaces of their own.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

/// Gives every part its own vertices and moves all parts but the first by up to `most` (m) each in its own
/// way: walls that coincide leave cells open.
void setPartsApart(RepairMesh& repair, double most);

}  // namespace demolish
