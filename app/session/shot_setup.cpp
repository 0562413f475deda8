// Placement of body and ball, choice of substeps.
#include "app/session/shot_setup.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kKappa = 0.68;    // dt_crit c_eff / h of the beam law, models.md E.1: 0.65-0.72
constexpr double kGravity = 9.81;  // m/s^2
constexpr double kSagFactor = 60;  // c_eff / sqrt(g H) at which no model of models.md E.4 sagged visibly
constexpr uint32_t kLeastSubsteps = 40;

glm::dvec3 toGlm(const Double3& v) {
    return {v.x, v.y, v.z};
}
Double3 fromGlm(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

double heightOf(const BreakableBody& body) {
    return body.bounds_max.y - body.bounds_min.y;
}

/// Across the longer horizontal side, a little from above the horizon of nothing: level flight.
glm::dvec3 flightDirection(const Shot& shot, const BreakableBody& body) {
    const glm::dvec3 chosen = toGlm(shot.impact.direction);
    if (glm::length(chosen) > 1e-9) return glm::normalize(chosen);
    const double along_x = body.bounds_max.x - body.bounds_min.x;
    const double along_z = body.bounds_max.z - body.bounds_min.z;
    return along_x >= along_z ? glm::dvec3(0, 0, -1) : glm::dvec3(-1, 0, 0);
}

/// Middle of the particles near the height of the impact; on the body even where its middle is hollow.
glm::dvec3 aimPoint(const Shot& shot, const BreakableBody& body) {
    const double y = body.bounds_min.y + shot.impact.height_fraction * heightOf(body);
    const double slab = std::max(0.05 * heightOf(body), body.spacing);
    glm::dvec3 sum(0);
    size_t count = 0;
    for (const auto& particle : body.particles) {
        if (std::abs(particle.seed.y - y) > slab) continue;
        sum += toGlm(particle.seed);
        ++count;
    }
    const glm::dvec3 middle = count > 0 ? sum / static_cast<double>(count) : glm::dvec3(0, y, 0);
    return {middle.x, y, middle.z};
}

/// Where the centre of a ball of `radius` is when it touches the body, flying through `aim`: from the
/// particles' depth.
glm::dvec3 touchPoint(const BreakableBody& body, glm::dvec3 aim, const glm::dvec3& direction, double radius) {
    double farthest = -1e300;
    double nearest_miss = 1e300;
    glm::dvec3 nearest(aim);
    for (const auto& particle : body.particles) {
        const glm::dvec3 offset = toGlm(particle.seed) - aim;
        const double along = -glm::dot(offset, direction);
        const double aside = glm::length(offset + along * direction);
        const double reach = radius + particle.depth;
        if (aside < reach) farthest = std::max(farthest, along + std::sqrt(reach * reach - aside * aside));
        if (aside < nearest_miss) {
            nearest_miss = aside;
            nearest = toGlm(particle.seed);
        }
    }
    if (farthest > -1e299) return aim - farthest * direction;
    return nearest -
           (radius + 0.5 * body.spacing) * direction;  // a hole at the aim: hit the nearest particle
}

/// A ball that is at `point` with velocity `velocity` after `flight` seconds under gravity.
Projectile thrown(const glm::dvec3& point, const glm::dvec3& velocity, double flight, double radius) {
    const glm::dvec3 gravity(0, -kGravity, 0);
    Projectile ball;
    ball.position = fromGlm(point - flight * velocity + 0.5 * flight * flight * gravity);
    ball.velocity = fromGlm(velocity - flight * gravity);
    ball.radius = radius;
    return ball;
}

/// The flight is cut short so that the ball starts above the floor.
Projectile thrownAboveFloor(const glm::dvec3& point, const glm::dvec3& velocity, double flight,
                            double radius) {
    Projectile ball = thrown(point, velocity, flight, radius);
    for (int tries = 0; tries < 8 && ball.position.y < 1.05 * radius; ++tries)
        ball = thrown(point, velocity, flight *= 0.7, radius);
    return ball;
}

void placeDropped(const Shot& shot, const BreakableBody& body, BodyInstance& instance) {
    const glm::dquat rotation(toGlm(shot.impact.tilt));
    double lowest = 1e300;
    for (const auto& particle : body.particles)
        lowest = std::min(lowest, (rotation * toGlm(particle.seed)).y - body.spacing);
    // Falls for some hundredths of a second, so that one sees it come.
    const double speed = shot.impact.velocity;
    const double gap = std::min(0.06 * speed, speed * speed / (2 * kGravity));
    instance.rotation = {rotation.x, rotation.y, rotation.z, rotation.w};
    instance.position = {0, gap - lowest, 0};
    instance.velocity = {0, -std::sqrt(std::max(0.0, speed * speed - 2 * kGravity * gap)), 0};
}

}  // namespace

double wantedWaveSpeed(const Shot& shot, double body_height) {
    if (shot.wave_speed > 0) return shot.wave_speed;
    const double brittle = shot.material.beta * shot.material.critical_velocity / kDefaultFailureStrain;
    return std::max(brittle, kSagFactor * std::sqrt(kGravity * body_height));
}

uint32_t substepsFor(const Shot& shot, const BreakableBody& body, double step_safety) {
    if (shot.substeps) return *shot.substeps;
    const double wanted = wantedWaveSpeed(shot, heightOf(body)) / (kKappa * step_safety * 60 * body.spacing);
    return static_cast<uint32_t>(std::clamp(std::ceil(wanted), double{kLeastSubsteps}, kSubstepRange.most));
}

SceneSetup makeSetup(const Shot& shot, std::shared_ptr<const BreakableBody> body) {
    SceneSetup setup;
    setup.params.frame_time = 1 / shot.fps;
    setup.params.substeps = substepsFor(shot, *body, setup.params.step_safety);
    setup.params.scene_radius = shot.scene_radius;
    setup.params.seed = shot.seed;
    const bool dropped = shot.impact.kind == ImpactKind::kDrop && shot.impact.velocity > 0;
    setup.params.settle_time = dropped ? 0 : shot.settle_time;
    BodyInstance instance;
    instance.material = shot.material;
    if (dropped) placeDropped(shot, *body, instance);
    instance.body = std::move(body);
    setup.bodies.push_back(std::move(instance));
    return setup;
}

double ballRadius(const Shot& shot, const BreakableBody& body) {
    return shot.impact.ball_radius > 0 ? shot.impact.ball_radius : heightOf(body) / 12;
}

std::optional<Projectile> makeBall(const Shot& shot, const BreakableBody& body) {
    if (shot.impact.kind != ImpactKind::kBall || shot.impact.velocity <= 0) return std::nullopt;
    const double radius = ballRadius(shot, body);
    const glm::dvec3 direction = flightDirection(shot, body);
    const glm::dvec3 point = touchPoint(body, aimPoint(shot, body), direction, radius);
    return thrownAboveFloor(point, shot.impact.velocity * direction, shot.impact.arrival_time, radius);
}

Projectile makeBallAt(const Shot& shot, const BreakableBody& body, const Double3& from,
                      const Double3& target) {
    constexpr double kShortFlight = 0.06;  // s: a click should hit at once, and the ball still be seen coming
    const double radius = ballRadius(shot, body);
    const glm::dvec3 path = toGlm(target) - toGlm(from);
    const double distance = glm::length(path);
    const glm::dvec3 direction = distance > 1e-9 ? path / distance : glm::dvec3(0, 0, -1);
    const double speed = std::max(shot.impact.velocity, 0.1);
    const double flight = std::min(kShortFlight, 0.8 * distance / speed);
    return thrownAboveFloor(toGlm(target) - 1.05 * radius * direction, speed * direction, flight, radius);
}

engine::Camera framedCamera(const BreakableBody& body) {
    const glm::dvec3 size = toGlm(body.bounds_max) - toGlm(body.bounds_min);
    const auto radius = static_cast<float>(0.5 * glm::length(size));
    const glm::vec3 centre = glm::vec3(0.5 * (toGlm(body.bounds_max) + toGlm(body.bounds_min)));
    engine::Camera camera;
    camera.target = centre;
    // From the longer side, a little to the right and above.
    const glm::vec3 side = size.x >= size.z ? glm::vec3(0.55f, 0.32f, 1.0f) : glm::vec3(1.0f, 0.32f, 0.55f);
    camera.eye = centre + side;
    camera.near_plane = 0.02f * radius;
    camera.far_plane = 200.0f * radius;
    camera.frame(centre, 1.35f * radius);
    return camera;
}

}  // namespace demolish
