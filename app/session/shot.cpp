// SPDX-License-Identifier: Apache-2.0
// Ranges of a shot's values and what a change of them costs.
#include "app/session/shot.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "app/session/shot_bodies.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

/// What a threshold hangs on, but for the velocity.
bool sameAim(const Impact& a, const Impact& b) {
    return a.body == b.body && a.ball_radius == b.ball_radius && a.direction == b.direction &&
           a.height_fraction == b.height_fraction;
}

/// Cells lie round where the shot is aimed.
bool hangsOnAim(const Shot& shot) {
    return shot.refine > 1 || (laysToughCells(shot) && shot.pattern == Pattern::kRadial);
}
void keepAim(const Impact& aimed, Impact& impact) {
    impact.kind = aimed.kind;
    impact.direction = aimed.direction;
    impact.height_fraction = aimed.height_fraction;
    impact.tilt = aimed.tilt;
}

// What a shot has taken over from another no longer tells them apart: each of these takes what one level of
// Change stands for. What none of them names asks for everything anew.

void takeWhatIsOnlyShown(const Shot& from, Shot& to) {
    to.scene = from.scene;
    to.scene_file = from.scene_file;
    to.paper_model = from.paper_model;
    to.material_name = from.material_name;
    to.inner_material = from.inner_material;
    to.material.name = from.material.name;
    to.material.tensile_strength = from.material.tensile_strength;
    to.phases = from.phases;
    to.look = from.look;
    to.looks = from.looks;
    to.lighting = from.lighting;
    to.environment = from.environment;
    to.lens = from.lens;
    to.camera = from.camera;
    to.camera_path = from.camera_path;
    to.impact.times_threshold = from.impact.times_threshold;
    if (from.impact.kind != ImpactKind::kDrop) to.impact.tilt = from.impact.tilt;
}

/// A drop's velocity is the body's own from the start; a ball is fired afterwards. Another aim needs another
/// strength where that is to follow the velocity to break at.
void takeWhatIsLive(const Shot& from, Shot& to) {
    to.balls = from.balls;
    to.effects.on = from.effects.on;
    to.effects.grit = from.effects.grit;
    to.effects.dust = from.effects.dust;
    to.effects.sparks = from.effects.sparks;
    to.effects.crumbling = from.effects.crumbling;
    to.time_scale = from.time_scale;
    if (to.impact.kind != from.impact.kind) return;
    if ((from.break_at || hangsOnAim(from)) && !sameAim(to.impact, from.impact)) return;
    const Impact before = to.impact;
    to.impact = from.impact;
    if (before.kind != ImpactKind::kDrop) return;
    to.impact.velocity = before.velocity;
    to.impact.tilt = before.tilt;
}

void takeWhatTheSolverIsMadeOf(const Shot& from, Shot& to) {
    to.strength_row = from.strength_row;
    const uint32_t cells = to.material.tough_cells;
    to.material = from.material;
    to.break_at = from.break_at;
    const Impact impact = to.impact;
    to.impact = from.impact;
    to.wave_speed = from.wave_speed;
    to.substeps = from.substeps;
    to.settle_time = from.settle_time;
    to.settle_scale = from.settle_scale;
    to.scene_radius = from.scene_radius;
    const bool lay = laysToughCells(from) || laysToughCells(to);
    to.method = from.method;
    if (lay)
        to.material.tough_cells = cells;
    else
        to.pattern = from.pattern;
    if (hangsOnAim(from)) keepAim(impact, to.impact);
    to.hand_over = from.hand_over;
    to.sleeping = from.sleeping;
    to.colliders = from.colliders;
    to.effects = from.effects;
    to.fps = from.fps;
}

}  // namespace

std::string plainNumber(double value) {
    std::ostringstream text;
    const bool whole = value == std::floor(value) && std::abs(value) < 1e16;  // false for NaN
    text << std::setprecision(whole ? 16 : 6) << value;
    return text.str();
}

void requireInRange(const std::string& name, double value, const Range& range, const std::string& unit) {
    if (std::isfinite(value) && value >= range.least && value <= range.most) return;
    const std::string with_unit = unit.empty() ? "" : " " + unit;
    throw UsageError(name + " is " + plainNumber(value) + with_unit + "; it must be between " +
                     plainNumber(range.least) + " and " + plainNumber(range.most) + with_unit);
}

void validate(const Shot& shot) {
    requireInRange("the impact velocity", shot.impact.velocity, kVelocityRange, "m/s");
    if (shot.break_at) requireInRange("the velocity to break at", *shot.break_at, kBreakAtRange, "m/s");
    requireInRange("the height", shot.height, kHeightRange, "m");
    requireInRange("the thickness of sheets", shot.repair.thickness, kThicknessRange, "m");
    requireInRange("the frame rate", shot.fps, kFpsRange, "frames/s");
    requireInRange("the time scale", shot.time_scale, kTimeScaleRange, "");
    requireInRange("the ball's radius", shot.impact.ball_radius, {0, 100}, "m");
    requireInRange("the amount of grit", shot.effects.grit, kAmountRange, "");
    requireInRange("the amount of dust", shot.effects.dust, kAmountRange, "");
    requireInRange("the amount of sparks", shot.effects.sparks, kAmountRange, "");
    for (const TimedBall& ball : shot.balls)
        requireInRange("the velocity of a ball of the scene", ball.speed_share * shot.impact.velocity,
                       kVelocityRange, "m/s");
    if (shot.fineness.particle_size)
        requireInRange("the particle size", *shot.fineness.particle_size, kParticleSizeRange, "m");
    if (shot.fineness.particles)
        requireInRange("the number of particles", *shot.fineness.particles, {kMinParticles, kMaxParticles},
                       "");
    requireInRange("the refinement", shot.refine, kRefineRange, "");
    if (shot.painted)
        requireInRange("the least painted strength", shot.painted->least, kPaintedLeastRange, "");
    if (shot.substeps) requireInRange("the number of substeps", *shot.substeps, kSubstepRange, "");
}

Change changeBetween(const Shot& before, const Shot& after) {
    Shot shot = before;
    takeWhatIsOnlyShown(after, shot);
    if (shot == after) return Change::kNothing;
    takeWhatIsLive(after, shot);
    if (shot == after) return Change::kLive;
    takeWhatTheSolverIsMadeOf(after, shot);
    return shot == after ? Change::kSolver : Change::kBody;
}

bool sameSubject(const Shot& a, const Shot& b) {
    return a.scene == b.scene && a.scene_file == b.scene_file && a.model == b.model && a.part == b.part;
}

}  // namespace demolish
