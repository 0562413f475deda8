// SPDX-License-Identifier: Apache-2.0
// Shots as the sheets describe them: a body dropped, or hit by an iron ball (models.md E.2, E.3).
#pragma once
#include <functional>
#include <memory>

#include "tests/physics/models/pieces.h"

namespace demolish::tests {

/// beam law, ci = 3, no Weibull, zeta_m = .3, mu = .5, e = .2, mu_r = .2, beta = .4; K tough cells.
Material sheetMaterial(double critical_velocity, uint32_t cells);

/// Stands on the floor, no gravity.
SceneSetup standing(std::shared_ptr<const BreakableBody> body, const Material& material, uint32_t substeps);
/// Turned by these angles (rad, about x, then y, then z), its lowest cell just above the floor, falling at
/// `speed`.
SceneSetup dropped(std::shared_ptr<const BreakableBody> body, const Material& material, uint32_t substeps,
                   const Double3& tilt, double speed);
/// Hit at `height_fraction` of its height by an iron ball that flies along -x and is just about to touch.
SceneSetup hitByBall(std::shared_ptr<const BreakableBody> body, const Material& material, uint32_t substeps,
                     double ball_radius, double speed, double height_fraction = 0.5);

/// The speed between `low` and `high` at which a tenth of a second breaks the body, by `rounds` halvings.
double thresholdSpeed(const std::function<SceneSetup(double speed)>& shot, double low, double high,
                      int rounds);

}  // namespace demolish::tests
