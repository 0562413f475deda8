// SPDX-License-Identifier: Apache-2.0
// Placement of bodies, choice of substeps.
#include "app/session/shot_setup.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/session/ball_flight.h"
#include "app/session/scene_anchors.h"
#include "app/session/scene_colliders.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_geometry.h"
#include "app/session/step_division.h"
#include "app/session/threshold.h"
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/turned_body.h"
#include "sim_cuda/api/wave_speed.h"

namespace demolish {
namespace {

constexpr double kSagFactor = 60;  // c_eff / sqrt(g H) at which no model of models.md E.4 sagged visibly
constexpr uint32_t kLeastSubsteps = 40;

Quaternion fromGlm(const glm::dquat& q) {
    return {q.x, q.y, q.z, q.w};
}

/// m, height of the turned body's lowest corner; where cells have none, of the spheres that they are.
double lowestPoint(const BreakableBody& body, const glm::dquat& rotation) {
    double lowest = 1e300;
    for (size_t i = 0; i < body.particles.size(); ++i) {
        const glm::dvec3 seed = toGlm(body.particles[i].seed);
        if (body.corners.start.empty())
            lowest = std::min(lowest, (rotation * seed).y - body.particles[i].depth);
        else
            for (uint32_t c = body.corners.start[i]; c < body.corners.start[i + 1]; ++c)
                lowest = std::min(lowest, (rotation * (seed + toGlm(body.corners.from_seed[c]))).y);
    }
    return lowest;
}

/// Turned and lifted so that it meets the floor with the chosen velocity.
void drop(const Shot& shot, const BreakableBody& body, const SceneBody& place, BodyInstance& instance) {
    const glm::dquat rotation = turnOf(place) * glm::dquat(toGlm(shot.impact.tilt));
    const double lowest = lowestPoint(body, rotation);
    // Falls for some hundredths of a second, so that one sees it come.
    const double speed = shot.impact.velocity;
    const double gap = std::min(0.06 * speed, speed * speed / (2 * kGravity));
    instance.rotation = fromGlm(rotation);
    instance.position.y += gap - lowest;
    instance.velocity = {0, -std::sqrt(std::max(0.0, speed * speed - 2 * kGravity * gap)), 0};
}

std::optional<PresetPieces> presetPiecesOf(const Shot& shot) {
    const auto turns = traitsOf(shot.method).pattern_turns;
    if (!turns) return std::nullopt;
    return PresetPieces{shot.pattern.value_or(usualPattern(shot.method)), *turns};
}

bool isDropped(const Shot& shot) {
    return shot.impact.kind == ImpactKind::kDrop && shot.impact.velocity > 0;
}

/// m/s, of what does not break: stress from hits of kVelocityRange stays a hundredth of its strength.
constexpr double kNeverBreaks = 1e6;

Material materialOf(const Shot& shot, const SceneBody& body) {
    Material material = body.material ? body.material->material : shot.material;
    if (body.breaks) return material;
    material.critical_velocity = kNeverBreaks;
    material.weibull_modulus = material.fracture_energy = 0;
    material.tough_cells = 1;  // one preset piece
    return material;
}

/// All but what follows from the bodies.
SolverParams paramsOf(const Shot& shot) {
    SolverParams params;
    const MethodTraits& method = traitsOf(shot.method);
    params.frame_time = 1 / shot.fps;
    params.seed = shot.seed;
    params.hand_over = method.may_rest && shot.hand_over;
    params.sleeping = method.may_rest && shot.sleeping;
    params.smooth_cracks = method.smooth_cracks;
    params.preset_pieces = presetPiecesOf(shot);
    params.colliders = collidersOf(shot);
    const bool settles = !isDropped(shot) && !params.preset_pieces;  // which steps bonds
    params.settle_time = settles ? shot.settle_time * shot.settle_scale : 0;
    params.settle_damping = SolverParams{}.settle_damping / shot.settle_scale;
    return params;
}

/// m, and how many times as far as the bodies: a model of two kilometres does not leave it as it falls.
constexpr double kLeastRoom = 1000, kRoom = 4;

/// m from the origin.
double roomFor(const SceneBox& box) {
    const double farthest = glm::length(glm::max(glm::abs(toGlm(box.low)), glm::abs(toGlm(box.high))));
    return std::max(kLeastRoom, kRoom * farthest);
}

/// Bodies that stand in different ways get one orientation, as mortar wants it; those that share cells and
/// way go on sharing.
void turnInTheirFrames(SceneSetup& setup) {
    std::vector<BodyInstance> before = setup.bodies;
    for (size_t b = 0; b < setup.bodies.size(); ++b) {
        BodyInstance& instance = setup.bodies[b];
        if (!instance.in_mortar || instance.rotation == Quaternion{}) continue;
        size_t first = 0;
        while (before[first].body != before[b].body || before[first].rotation != before[b].rotation ||
               !before[first].in_mortar)
            ++first;
        instance.body = first < b ? setup.bodies[first].body : turnedBody(*instance.body, instance.rotation);
        instance.rotation = {};
    }
}

/// Whether the scene fires them or a hand does.
ShotsToCome shotsToCome(const Shot& shot, const SceneSetup& setup) {
    ShotsToCome shots{shot.impact.velocity};
    if (shot.impact.kind != ImpactKind::kBall) return shots;
    for (const BodyInstance& body : setup.bodies)
        shots.radius = std::min(shots.radius, ballRadius(shot, *body.body));
    for (const TimedBall& ball : shot.balls)
        shots.radius = std::min(shots.radius, ball.radius.value_or(shots.radius));
    return shots;
}

}  // namespace

double wantedWaveSpeed(const Shot& shot, double body_height) {
    if (shot.wave_speed > 0) return shot.wave_speed;
    const double brittle = shot.material.beta * shot.material.critical_velocity / kDefaultFailureStrain;
    return std::max(brittle, kSagFactor * std::sqrt(kGravity * body_height));
}

uint32_t substepsFor(const Shot& shot, const BreakableBody& body, double step_safety) {
    if (shot.substeps) return *shot.substeps;
    const double speed = wantedWaveSpeed(shot, heightOf(body));
    double wanted = speed / (kKappa * step_safety * 60 * body.spacing);
    if (!body.bonds.empty()) {
        const auto tried = static_cast<uint32_t>(std::ceil(wanted));
        wanted = tried * speed / softenedWaveSpeed(body, shot.material, tried, step_safety);
    }
    return static_cast<uint32_t>(std::clamp(std::ceil(wanted), double{kLeastSubsteps}, kSubstepRange.most));
}

SceneSetup makeSetup(const Shot& shot, const BodyList& bodies) {
    SceneSetup setup;
    setup.params = paramsOf(shot);
    const std::vector<SceneBody> places = bodiesOf(shot);
    const std::vector<size_t> alike = firstAlike(places);
    const bool dropped = isDropped(shot);
    std::vector<double> share(places.size());
    uint32_t substeps = 0;
    for (size_t b = 0; b < places.size(); ++b) {
        const SceneBody& place = places[b];
        if (alike[b] == b) {
            const Shot of = asOf(shot, place);
            share[b] = lowestThresholdShare(of, *bodies.at(b));
            substeps = std::max(substeps, substepsFor(of, *bodies[b], setup.params.step_safety));
        }
        BodyInstance instance;
        instance.body = bodies.at(b);
        instance.material = materialOf(shot, place);
        instance.position = fromGlm(shot.height * toGlm(place.position));
        instance.rotation = fromGlm(turnOf(place));
        instance.velocity = place.velocity;
        instance.angular_velocity = place.spin;
        instance.threshold_share = share[alike[b]];
        instance.in_mortar = place.in_mortar;
        if (dropped) drop(shot, *instance.body, place, instance);
        setup.bodies.push_back(std::move(instance));
    }
    setup.anchors = anchorsOf(shot, setup.bodies);
    if (shot.mortar && !setup.params.preset_pieces) {  // which are cut body by body
        setup.mortar = Mortar{shot.mortar->tensile_strength, shot.height * shot.mortar->joint};
        turnInTheirFrames(setup);
    }
    setup.params.substeps = traitsOf(shot.method).times_substeps * substeps;
    if (!setup.params.preset_pieces) divideSteps(setup, shotsToCome(shot, setup));
    setup.params.scene_radius = shot.scene_radius > 0 ? shot.scene_radius : roomFor(sceneBox(shot, bodies));
    return setup;
}

bool takesOtherSteps(const Shot& shot, const SceneSetup& made) {
    return !made.params.preset_pieces && dividesOtherwise(made, shotsToCome(shot, made));
}

SceneBox sceneBox(const Shot& shot, const BodyList& bodies) {
    glm::dvec3 low(1e300), high(-1e300);
    const std::vector<SceneBody> places = bodiesOf(shot);
    for (size_t b = 0; b < places.size(); ++b) {
        const SceneBody& place = places[b];
        const BreakableBody& body = *bodies.at(b);
        for (int corner = 0; corner < 8; ++corner) {
            const auto pick = [corner](int axis, double least, double most) {
                return (corner >> axis & 1) != 0 ? most : least;
            };
            const glm::dvec3 at(pick(0, body.bounds_min.x, body.bounds_max.x),
                                pick(1, body.bounds_min.y, body.bounds_max.y),
                                pick(2, body.bounds_min.z, body.bounds_max.z));
            const glm::dvec3 placed = shot.height * toGlm(place.position) + turnOf(place) * at;
            low = glm::min(low, placed);
            high = glm::max(high, placed);
        }
    }
    return {fromGlm(low), fromGlm(high)};
}

engine::Camera framedCamera(const SceneBox& box) {
    const glm::dvec3 size = toGlm(box.high) - toGlm(box.low);
    const auto radius = static_cast<float>(0.5 * glm::length(size));
    const glm::vec3 centre = glm::vec3(0.5 * (toGlm(box.high) + toGlm(box.low)));
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
