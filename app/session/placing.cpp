// SPDX-License-Identifier: Apache-2.0
#include "app/session/placing.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "app/session/scene_colliders.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_geometry.h"
#include "sim_cuda/api/collider_distance.h"

namespace demolish {
namespace {

constexpr double kFar = 1e4;    // m
constexpr double kNear = 1e-4;  // m, this close is there

/// From a body's own frame to the scene.
struct Place {
    glm::dvec3 foot;
    glm::dquat turn;

    glm::dvec3 out(const glm::dvec3& own) const { return foot + turn * own; }
    glm::dvec3 in(const glm::dvec3& scene) const { return glm::inverse(turn) * (scene - foot); }
};

Place placeOf(const Shot& shot, const SceneBody& body) {
    const Quaternion& q = body.turn;
    return {shot.height * toGlm(body.position),
            glm::angleAxis(body.yaw, glm::dvec3(0, 1, 0)) * glm::dquat(q.w, q.x, q.y, q.z)};
}

/// Along a unit ray, to the nearest particle taken as a ball that reaches its neighbours; kFar past all.
double distanceTo(const BreakableBody& body, const glm::dvec3& origin, const glm::dvec3& way) {
    const double radius = 0.62 * body.spacing;  // half the diagonal's share of a grid's face
    double nearest = kFar;
    for (const auto& particle : body.particles) {
        const glm::dvec3 to = toGlm(particle.seed) - origin;
        const double along = glm::dot(to, way), aside2 = glm::dot(to, to) - along * along;
        if (along <= 0 || aside2 > radius * radius) continue;
        nearest = std::min(nearest, along - std::sqrt(radius * radius - aside2));
    }
    return nearest;
}

/// Along a unit ray, to the floor or a collider, by steps of the distance; kFar past all.
double distanceToColliders(const std::vector<Collider>& colliders, const glm::dvec3& origin,
                           const glm::dvec3& way, double most) {
    double along = 0;
    for (int step = 0; step < 256 && along < most; ++step) {
        const double free = colliderDistance(colliders, fromGlm(origin + along * way));
        if (free < kNear) return along;
        along += free;
    }
    return kFar;
}

}  // namespace

std::optional<RayHit> whatRayMeets(const Shot& shot, const BodyList& bodies, const engine::Ray& ray,
                                   std::optional<size_t> without) {
    const glm::dvec3 origin(ray.origin), way = glm::normalize(glm::dvec3(ray.direction));
    RayHit hit;
    double nearest = kFar;
    const std::vector<SceneBody> places = bodiesOf(shot);
    for (size_t b = 0; b < places.size() && b < bodies.size(); ++b) {
        if (b == without || places[b].hidden) continue;
        const Place place = placeOf(shot, places[b]);
        const double distance = distanceTo(*bodies[b], place.in(origin), glm::inverse(place.turn) * way);
        if (!(distance < nearest)) continue;
        nearest = distance;
        hit.body = b;
    }
    const double wall = distanceToColliders(collidersOf(shot), origin, way, std::min(nearest, kFar));
    if (wall < nearest) hit.body.reset();
    nearest = std::min(nearest, wall);
    if (nearest >= kFar) return std::nullopt;
    hit.point = origin + nearest * way;
    return hit;
}

std::array<glm::dvec3, 8> cornersOf(const Shot& shot, const BodyList& bodies, size_t body) {
    const BreakableBody& of = *bodies.at(body);
    const Place place = placeOf(shot, bodiesOf(shot).at(body));
    std::array<glm::dvec3, 8> corners;
    for (size_t k = 0; k < corners.size(); ++k)
        corners[k] = place.out({(k & 1) != 0 ? of.bounds_max.x : of.bounds_min.x,
                                (k & 2) != 0 ? of.bounds_max.y : of.bounds_min.y,
                                (k & 4) != 0 ? of.bounds_max.z : of.bounds_min.z});
    return corners;
}

double restingHeight(const Shot& shot, const BodyList& bodies, size_t body, double x, double z, double from) {
    std::vector<SceneBody> places = bodiesOf(shot);
    Shot moved = shot;
    moved.bodies = places;
    moved.bodies.at(body).position = {x / shot.height, 0, z / shot.height};
    const auto corners = cornersOf(moved, bodies, body);
    glm::dvec3 low = corners[0], high = corners[0];
    for (const glm::dvec3& corner : corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const glm::dvec3 above(x, from, z), down(0, -1, 0);
    double ground = from - distanceToColliders(collidersOf(shot), above, down, kFar);
    if (!(ground > -kFar / 2)) ground = 0;
    for (size_t b = 0; b < places.size() && b < bodies.size(); ++b) {
        if (b == body) continue;
        const Place place = placeOf(shot, places[b]);
        const BreakableBody& other = *bodies[b];
        for (const auto& particle : other.particles) {
            const glm::dvec3 at = place.out(toGlm(particle.seed));
            const bool is_below = at.x > low.x && at.x < high.x && at.z > low.z && at.z < high.z;
            // The depth of a particle is its distance to the surface: that of the top one reaches it.
            const double top = at.y + std::min(particle.depth, other.spacing);
            if (is_below && top <= from) ground = std::max(ground, top);
        }
    }
    return ground - low.y;
}

}  // namespace demolish
