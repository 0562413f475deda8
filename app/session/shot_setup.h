// From a shot's values and a body to the solver's setup: where the body stands, what hits it, how stiff it
// is.
#pragma once
#include <optional>

#include "app/session/shot.h"
#include "engine/scene/camera.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Wave speed c_eff (m/s) that the shot's stiffness is softened to: the scene's, else such that the strain at
/// failure is kDefaultFailureStrain and the body does not sag under its own weight (models.md E.1, E.2, E.4).
double wantedWaveSpeed(const Shot& shot, double body_height);
inline constexpr double kDefaultFailureStrain = 0.011;

/// n_sub of models.md E.1: c_eff / (kappa safety 60 h).
uint32_t substepsFor(const Shot& shot, const BreakableBody& body, double step_safety);

/// The body in its place, without projectiles: those are fired when the shot starts.
SceneSetup makeSetup(const Shot& shot, std::shared_ptr<const BreakableBody> body);

/// The ball of the shot, started so that it reaches the body's surface after Impact::arrival_time with the
/// chosen velocity (gravity on the way included). None when nothing is to hit the body.
std::optional<Projectile> makeBall(const Shot& shot, const BreakableBody& body);

/// A ball that passes `target` after a short flight from the side of `from`, with the shot's velocity and
/// radius there.
Projectile makeBallAt(const Shot& shot, const BreakableBody& body, const Double3& from,
                      const Double3& target);

double ballRadius(const Shot& shot, const BreakableBody& body);

/// Camera that shows body and impact, for shots that name none.
engine::Camera framedCamera(const BreakableBody& body);

}  // namespace demolish
