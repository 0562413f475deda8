// SPDX-License-Identifier: Apache-2.0
// Which parts are surfaces without an inside, and how thick they become.
#pragma once
#include "sim_cuda/authoring/repair/part_facts.h"

namespace demolish {

/// Particles that the thickness of sheets is chosen for; the same for any body, so that its shape does not
/// hang on how finely it is divided.
inline constexpr double kSheetParticles = 1200;

/// Sets PartFacts::is_sheet: parts whose caps would be large against themselves, or that hold next to no
/// volume with them. Where sheets hold less than half of the area, only the flattest stay ones, and a sheet
/// whose rim lies inside of solids is capped.
void findSheets(const RepairMesh& filled, std::vector<PartFacts>& facts);

/// m, by part; 0: not a sheet. `wanted` (m) where it is positive; else one and a half times the spacing of
/// kSheetParticles particles, and not more than the part's size bears.
std::vector<double> sheetThickness(const std::vector<PartFacts>& facts, double wanted);

/// Do sheets bound a solid together, as the unwelded faces of a box do? By the winding number of the whole
/// file on both sides of them: near a half on the wall of a solid, near nothing on a lone sheet. What a sheet
/// bounds by itself does not count: an open tube is a tube.
bool sheetsEncloseSolid(const RepairMesh& filled, const std::vector<PartFacts>& facts);

}  // namespace demolish
