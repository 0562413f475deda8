// SPDX-License-Identifier: Apache-2.0
// By the strain at failure, the longest cell, and the fastest of all that moves.
#include "app/session/step_division.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "app/session/shot_geometry.h"
#include "app/session/shot_setup.h"

namespace demolish {
namespace {

/// Strain at failure, with the usual kappa. Bodies of 0.11 and 0.36 found and lost a tenth of their energy;
/// by default it is 0.011, and cast iron as soft as the vase, of 0.09, keeps its own. What has more than 1 is
/// not meant to break, and nothing strains it so far.
constexpr double kRubberStrain = 0.1, kUnbreakable = 1;
/// Length of a bond in spacings. The needle that gained energy has 8, a vase of 60 cells 5.
constexpr double kLongCell = 6;

double strainAtFailure(const BreakableBody& body, const Material& material, const SolverParams& params) {
    const double wave_speed = kKappa * params.step_safety * 60 * body.spacing * params.substeps;
    return material.beta * material.critical_velocity / wave_speed;
}

bool hasLongCells(const BreakableBody& body) {
    const auto isLong = [&](const BondGeometry& bond) { return bond.length > kLongCell * body.spacing; };
    return std::ranges::any_of(body.bonds, isLong);
}

/// In which bonds and contacts of the body are stable together.
double divisionFor(const BodyInstance& body, const SolverParams& params) {
    if (body.body->bonds.empty()) return 1;
    const double strain = strainAtFailure(*body.body, body.material, params);
    const bool is_rubber = strain > kRubberStrain && strain < kUnbreakable;
    return is_rubber || hasLongCells(*body.body) ? 2 : 1;
}

/// m, of the body's own origin.
double reachOf(const BreakableBody& body) {
    return std::max(glm::length(toGlm(body.bounds_min)), glm::length(toGlm(body.bounds_max)));
}

/// m/s, at most, of a point `reach` m from the pivot.
double fastestOnPath(const MotionPath& path, double reach) {
    constexpr double kSteepest = 1.5;  // of a smooth path over the straight one between two keys
    double fastest = 0;
    PathKey before;
    for (const PathKey& key : path.keys) {
        const double way = glm::length(toGlm(key.way) - toGlm(before.way)) +
                           reach * glm::length(toGlm(key.turn) - toGlm(before.turn));
        fastest = std::max(fastest, kSteepest * way / (key.time - before.time));
        before = key;
    }
    return fastest;
}

/// m/s, of what is shot, flies at the start or is led, after it has fallen past all bodies.
double fastestOf(const SceneSetup& setup, double shot_speed) {
    double fastest = shot_speed, top = 0, bottom = 0, reach = 0;
    for (const BodyInstance& body : setup.bodies) {
        const double own = reachOf(*body.body);
        reach = std::max(reach, own);
        top = std::max(top, body.position.y + own);
        bottom = std::min(bottom, body.position.y - own);
        fastest = std::max(
            fastest, glm::length(toGlm(body.velocity)) + own * glm::length(toGlm(body.angular_velocity)));
    }
    for (const Anchor& anchor : setup.anchors) fastest = std::max(fastest, fastestOnPath(anchor.path, reach));
    return std::sqrt(fastest * fastest + 2 * glm::length(toGlm(setup.params.gravity)) * (top - bottom));
}

/// Of the setup's bodies, for undivided params.
uint32_t divisionOf(const SceneSetup& setup, const SolverParams& params, const ShotsToCome& shots) {
    const double step = 1 / (60.0 * params.substeps), way = fastestOf(setup, shots.speed) * step;
    double division = std::ceil(shots.speed * step / (kFarthestBall * shots.radius));
    for (const BodyInstance& body : setup.bodies)
        division = std::max(
            {division, divisionFor(body, params), std::ceil(way / (kFarthestStep * body.body->spacing))});
    const double most = std::max(1.0, std::floor(kSubstepRange.most / params.substeps));
    return static_cast<uint32_t>(std::clamp(division, 1.0, most));
}

}  // namespace

void divideSteps(SceneSetup& setup, const ShotsToCome& shots) {
    SolverParams& params = setup.params;
    const uint32_t division = divisionOf(setup, params, shots);
    params.substeps *= division;
    params.step_safety /= division;
}

bool dividesOtherwise(const SceneSetup& divided, const ShotsToCome& shots) {
    SolverParams params = divided.params;
    const auto division = static_cast<uint32_t>(std::lround(SolverParams{}.step_safety / params.step_safety));
    params.substeps /= division;
    params.step_safety = SolverParams{}.step_safety;
    return divisionOf(divided, params, shots) != division;
}

}  // namespace demolish
