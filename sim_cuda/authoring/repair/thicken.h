// SPDX-License-Identifier: Apache-2.0
// Sheets become plates.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

/// Replaces each part whose thickness (m, by part) is positive: its caps go, every patch of it becomes a part
/// of its own with the surface half of the thickness to either side and a strip along every open edge. Both
/// faces keep normals and texture coordinates.
void thickenSheets(RepairMesh& filled, const std::vector<double>& thickness);

}  // namespace demolish
