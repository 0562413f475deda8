// SPDX-License-Identifier: Apache-2.0
// From a shot's values and its bodies to the solver's setup: where each body stands, how stiff it is, where
// the camera looks from.
#pragma once
#include <memory>
#include <vector>

#include "app/session/shot.h"
#include "engine/scene/camera.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Wave speed c_eff (m/s) that the shot's stiffness is softened to: the scene's, else such that the strain at
/// failure is kDefaultFailureStrain and the body does not sag under its own weight (models.md E.1, E.2, E.4).
double wantedWaveSpeed(const Shot& shot, double body_height);
inline constexpr double kDefaultFailureStrain = 0.011;
/// dt_crit c_eff / h of compact bodies, models.md E.1: 0.65-0.72.
inline constexpr double kKappa = 0.68;

/// n_sub of models.md E.1: c_eff / (kappa safety 60 h), with the kappa of this very body, or the wave speed
/// and the strength with it would hang on how many cells there are through a wall. Of the usual kappa without
/// bonds.
uint32_t substepsFor(const Shot& shot, const BreakableBody& body, double step_safety);

/// Cells of each body of the shot, in their order; of a shot without a list those of its one body.
using BodyList = std::vector<std::shared_ptr<const BreakableBody>>;

/// The bodies in their places, without projectiles: those are fired while the shot runs. So many substeps
/// that no body is softer than its own material wants it, or a multiple of them (step_division.h).
SceneSetup makeSetup(const Shot& shot, const BodyList& bodies);
/// Would makeSetup() choose other substeps for this velocity and size of the balls?
bool takesOtherSteps(const Shot& shot, const SceneSetup& made);

/// Box round all bodies of the shot as they stand, m.
struct SceneBox {
    Double3 low, high;
};
SceneBox sceneBox(const Shot& shot, const BodyList& bodies);

/// Camera that shows all bodies and the impact, for shots that name none.
engine::Camera framedCamera(const SceneBox& box);

}  // namespace demolish
