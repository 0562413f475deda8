// SPDX-License-Identifier: Apache-2.0
// What each part of a mesh measures once its holes are capped.
#pragma once
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

struct PartFacts {
    double area = 0, cap_area = 0;  ///< m^2, of the file's triangles and of the caps
    double volume = 0;              ///< m^3, with the caps; negative: inside out
    Double3 lower{1e300, 1e300, 1e300}, upper{-1e300, -1e300, -1e300};  ///< m
    bool was_open = false;                                              ///< has caps
    bool was_touched = false;                                           ///< triangles of it were turned
    bool is_cavity = false;  ///< meant to be inside out: a hollow in another part
    bool is_sheet = false;   ///< without its caps: to be given a thickness
    /// m
    double diagonal() const;
};

/// Next to no volume (m^3) for an area (m^2) and a diagonal (m): a surface, not a body.
bool isFlat(double volume, double area, double diagonal);

/// By part, after fillHoles(). `patch_touched` as from orientPatches().
std::vector<PartFacts> factsOfParts(const RepairMesh& filled, const std::vector<char>& patch_touched);

}  // namespace demolish
