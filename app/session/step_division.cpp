// SPDX-License-Identifier: Apache-2.0
// By the strain at failure, and by the longest cell.
#include "app/session/step_division.h"

#include <algorithm>

#include "app/session/shot_setup.h"

namespace demolish {
namespace {

/// Strain at failure, with the usual kappa. Bodies of 0.11 and 0.36 found and lost a tenth of their energy;
/// by default it is 0.011, and cast iron as soft as the vase, of 0.09, keeps its own. What has more than 1 is
/// not meant to break, and nothing strains it so far.
constexpr double kRubberStrain = 0.1, kUnbreakable = 1;
/// Length of a bond in spacings. The needle that gained energy has 8, a vase of 60 cells 5.
constexpr double kLongCell = 6;

double strainAtFailure(const BreakableBody& body, const Material& material, uint32_t substeps,
                       double step_safety) {
    const double wave_speed = kKappa * step_safety * 60 * body.spacing * substeps;
    return material.beta * material.critical_velocity / wave_speed;
}

bool hasLongCells(const BreakableBody& body) {
    const auto isLong = [&](const BondGeometry& bond) { return bond.length > kLongCell * body.spacing; };
    return std::ranges::any_of(body.bonds, isLong);
}

}  // namespace

uint32_t stepDivision(const BreakableBody& body, const Material& material, uint32_t substeps,
                      double step_safety) {
    if (body.bonds.empty()) return 1;
    const double strain = strainAtFailure(body, material, substeps, step_safety);
    const bool is_rubber = strain > kRubberStrain && strain < kUnbreakable;
    return is_rubber || hasLongCells(body) ? 2 : 1;
}

}  // namespace demolish
