// SPDX-License-Identifier: Apache-2.0
// Looks for what the repair made: caps of holes, rims of sheets.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

/// Triangles without a source take material, colour and UV from the file's triangles at their corners, so
/// that looks run on over rims; farther from these, from each other. Normals stay. Nothing happens where no
/// triangle has a material.
void dressCaps(RepairMesh& repair);

}  // namespace demolish
