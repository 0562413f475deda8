// SPDX-License-Identifier: Apache-2.0
// Where bodies lie against each other at the start, cell by cell. Host code in double.
#pragma once
#include <functional>
#include <vector>

#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

/// Two cells of different bodies whose outsides face each other.
struct FacingCells {
    uint32_t i = 0, j = 0;  ///< i < j, particles of the scene
    double area = 0;        ///< m^2, where they lie against each other
    double gap = 0;         ///< m, between their outsides there on the mean; < 0: they reach into each other
    Vec3<double> normal;    ///< unit, of the outside of i there
};

/// m: outsides of bodies a and b (a < b) no farther apart than this face each other; none at all if < 0.
using FacingGap = std::function<double(uint32_t a, uint32_t b)>;

/// Of all bodies, sorted by (i, j). From the outsides that are drawn: a body without draw geometry faces
/// nothing.
std::vector<FacingCells> facingCells(const SceneSetup& setup, const SceneTables& tables,
                                     const FacingGap& gap);

}  // namespace demolish
