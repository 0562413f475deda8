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

/// n_sub of models.md E.1: c_eff / (kappa safety 60 h), with the kappa of this very body, or the wave speed
/// and the strength with it would hang on how many cells there are through a wall. Of the usual kappa without
/// bonds.
uint32_t substepsFor(const Shot& shot, const BreakableBody& body, double step_safety);

/// How the shot's model is to be read.
MeshPlacement placementOf(const Shot& shot);

/// How many different fillings the shot's bodies ask for, at least 1.
uint32_t variantCount(const Shot& shot);

/// The bodies in their places, without projectiles: those are fired while the shot runs. One filling a
/// variant; all of the same mesh.
SceneSetup makeSetup(const Shot& shot, const std::vector<std::shared_ptr<const BreakableBody>>& variants);

/// Box round all bodies of the shot as they stand, m. `body` is any of its fillings.
struct SceneBox {
    Double3 low, high;
};
SceneBox sceneBox(const Shot& shot, const BreakableBody& body);

/// Camera that shows all bodies and the impact, for shots that name none.
engine::Camera framedCamera(const SceneBox& box);

}  // namespace demolish
