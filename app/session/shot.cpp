// SPDX-License-Identifier: Apache-2.0
// Ranges of a shot's values and what a change of them costs.
#include "app/session/shot.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <type_traits>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

bool same(const Double3& a, const Double3& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool same(const Placement& a, const Placement& b) {
    return same(a.position, b.position) && a.yaw == b.yaw && a.variant == b.variant;
}

template <class Part>
bool same(const std::optional<Part>& a, const std::optional<Part>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    if constexpr (std::is_same_v<Part, Double3>)
        return same(*a, *b);
    else
        return *a == *b;
}

bool same(const TimedBall& a, const TimedBall& b) {
    return a.arrival_time == b.arrival_time && a.flight_time == b.flight_time && a.body == b.body &&
           a.speed_share == b.speed_share && same(a.radius, b.radius) && same(a.direction, b.direction) &&
           same(a.height_fraction, b.height_fraction) && same(a.aim, b.aim);
}

template <class Part>
bool sameList(const std::vector<Part>& a, const std::vector<Part>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Part& x, const Part& y) { return same(x, y); });
}

bool sameBody(const Shot& a, const Shot& b) {
    return a.model == b.model && a.height == b.height && a.seed == b.seed && a.device == b.device &&
           sameList(a.bodies, b.bodies) && a.fineness.particles == b.fineness.particles &&
           a.fineness.particle_size == b.fineness.particle_size && a.fineness.full == b.fineness.full &&
           a.fineness.draft == b.fineness.draft;
}

bool sameMaterial(const Material& a, const Material& b) {
    return a.density == b.density && a.youngs_modulus == b.youngs_modulus &&
           a.poisson_ratio == b.poisson_ratio && a.friction == b.friction && a.restitution == b.restitution &&
           a.rolling_friction == b.rolling_friction && a.damping_ratio == b.damping_ratio &&
           a.critical_velocity == b.critical_velocity && a.beta == b.beta &&
           a.weibull_modulus == b.weibull_modulus && a.tough_cells == b.tough_cells &&
           a.tough_factor == b.tough_factor && a.adhesion_energy == b.adhesion_energy &&
           a.bond_law == b.bond_law && a.shear_ratio == b.shear_ratio;
}

/// A drop's velocity is the body's own from the start; a ball is fired afterwards.
bool sameImpactForSolver(const Impact& a, const Impact& b) {
    if (a.kind != b.kind) return false;
    return a.kind != ImpactKind::kDrop || (a.velocity == b.velocity && same(a.tilt, b.tilt));
}

/// What a threshold hangs on, but for the velocity.
bool sameAim(const Impact& a, const Impact& b) {
    return a.ball_radius == b.ball_radius && same(a.direction, b.direction) &&
           a.height_fraction == b.height_fraction;
}

bool sameBall(const Impact& a, const Impact& b) {
    return a.velocity == b.velocity && sameAim(a, b) && a.arrival_time == b.arrival_time;
}

bool sameStrength(const Shot& a, const Shot& b) {
    return sameMaterial(a.material, b.material) && a.break_at == b.break_at &&
           (!b.break_at || sameAim(a.impact, b.impact));
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
    requireInRange("the frame rate", shot.fps, kFpsRange, "frames/s");
    requireInRange("the time scale", shot.time_scale, kTimeScaleRange, "");
    requireInRange("the ball's radius", shot.impact.ball_radius, {0, 100}, "m");
    for (const TimedBall& ball : shot.balls)
        requireInRange("the velocity of a ball of the scene", ball.speed_share * shot.impact.velocity,
                       kVelocityRange, "m/s");
    if (shot.fineness.particle_size)
        requireInRange("the particle size", *shot.fineness.particle_size, kParticleSizeRange, "m");
    if (shot.fineness.particles)
        requireInRange("the number of particles", *shot.fineness.particles, {kMinParticles, kMaxParticles},
                       "");
    if (shot.substeps) requireInRange("the number of substeps", *shot.substeps, kSubstepRange, "");
}

Change changeBetween(const Shot& before, const Shot& after) {
    if (!sameBody(before, after)) return Change::kBody;
    const bool same_solver = sameStrength(before, after) && before.wave_speed == after.wave_speed &&
                             before.substeps == after.substeps && before.settle_time == after.settle_time &&
                             before.scene_radius == after.scene_radius && before.fps == after.fps &&
                             before.strength_row == after.strength_row &&
                             before.hand_over == after.hand_over && before.sleeping == after.sleeping &&
                             sameImpactForSolver(before.impact, after.impact);
    if (!same_solver) return Change::kSolver;
    const bool same_live = sameBall(before.impact, after.impact) && sameList(before.balls, after.balls) &&
                           before.time_scale == after.time_scale;
    return same_live ? Change::kNothing : Change::kLive;
}

bool sameSubject(const Shot& a, const Shot& b) {
    return a.scene == b.scene && a.model == b.model;
}

}  // namespace demolish
