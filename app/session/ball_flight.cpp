// SPDX-License-Identifier: Apache-2.0
// Aim on the body's particles, flight back from the impact.
#include "app/session/ball_flight.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <iterator>
#include <map>
#include <span>

#include "app/session/scene_colliders.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_geometry.h"
#include "sim_cuda/api/collider_distance.h"

namespace demolish {
namespace {

/// m, edges of the box about a body
glm::dvec3 boxOf(const BreakableBody& body) {
    return toGlm(body.bounds_max) - toGlm(body.bounds_min);
}
double longestAcross(const glm::dvec3& box) {
    return std::max(box.x, box.z);
}
bool liesFlat(const glm::dvec3& box) {
    return box.y < 0.15 * longestAcross(box);
}

glm::dvec3 wayOf(const Double3& chosen_direction, const glm::dvec3& box) {
    const glm::dvec3 chosen = toGlm(chosen_direction);
    if (glm::length(chosen) > 1e-9) return glm::normalize(chosen);
    if (liesFlat(box)) return {0, -1, 0};
    return box.x >= box.z ? glm::dvec3(0, 0, -1) : glm::dvec3(-1, 0, 0);
}

/// Middle of the particles near the height of the impact; on the body even where its middle is hollow.
glm::dvec3 aimPoint(const BreakableBody& body, double height_fraction) {
    const double y = body.bounds_min.y + height_fraction * heightOf(body);
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

/// Middle of the outline that the body shows to who looks along `way` (unit); where it is hollow there, the
/// particle in sight that is nearest to that.
glm::dvec3 middleSeen(const BreakableBody& body, const glm::dvec3& way) {
    const glm::dvec3 up = std::abs(way.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(way, up)), above = glm::cross(right, way);
    const glm::dvec3 centre = 0.5 * (toGlm(body.bounds_min) + toGlm(body.bounds_max));
    // The picture in squares that no row of particles slips through, and what is nearest in each. Counted
    // from the centre in whole numbers, so that what is symmetric has its middle there to the last bit.
    const double square = 1.2 * body.spacing;
    using Square = std::pair<int64_t, int64_t>;
    const auto squareOf = [&](const glm::dvec3& p) {
        return Square(std::llround(glm::dot(p - centre, right) / square),
                      std::llround(glm::dot(p - centre, above) / square));
    };
    std::map<Square, glm::dvec3> seen;
    for (const auto& particle : body.particles) {
        const glm::dvec3 seed = toGlm(particle.seed);
        const auto [known, is_new] = seen.try_emplace(squareOf(seed), seed);
        if (!is_new && glm::dot(seed - known->second, way) < 0) known->second = seed;
    }
    Square sum{0, 0};
    for (const auto& [at, seed] : seen) sum = {sum.first + at.first, sum.second + at.second};
    const double share = square / static_cast<double>(seen.size());
    const glm::dvec3 middle = centre + share * static_cast<double>(sum.first) * right +
                              share * static_cast<double>(sum.second) * above;
    if (seen.contains(squareOf(middle))) return middle;
    const auto aside = [&](const glm::dvec3& p) { return glm::length(glm::cross(p - middle, way)); };
    return std::min_element(seen.begin(), seen.end(),
                            [&](const auto& a, const auto& b) { return aside(a.second) < aside(b.second); })
        ->second;
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

/// Shares of a flight, from its start, at which it must be clear of what stands round the scene; near its end
/// it may well be beside some of that.
constexpr double kLooks[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};

/// `colliders`: the floor first, above which the ball must only start.
bool isClear(const ThrownBall& thrown, std::span<const Collider> colliders) {
    const Projectile& ball = thrown.ball;
    if (colliderDistance(colliders, ball.position) < 1.05 * ball.radius) return false;
    const glm::dvec3 gravity(0, -kGravity, 0);
    const auto walls = colliders.subspan(std::min<size_t>(1, colliders.size()));
    return std::all_of(std::begin(kLooks), std::end(kLooks), [&](double share) {
        const double time = share * thrown.flight;
        const glm::dvec3 at =
            toGlm(ball.position) + time * toGlm(ball.velocity) + 0.5 * time * time * gravity;
        return !(colliderDistance(walls, fromGlm(at)) < ball.radius);
    });
}

/// The flight is cut short so that the ball starts in free air, above the floor and on the near side of
/// walls.
ThrownBall thrownFree(const glm::dvec3& point, const glm::dvec3& velocity, double flight, double radius,
                      std::span<const Collider> colliders) {
    ThrownBall result{thrown(point, velocity, flight, radius), flight};
    for (int tries = 0; tries < 8 && !isClear(result, colliders); ++tries) {
        result.flight *= 0.7;
        result.ball = thrown(point, velocity, result.flight, radius);
    }
    return result;
}

TimedBall ballOf(const Impact& impact) {
    TimedBall ball;
    ball.body = impact.body;
    ball.arrival_time = impact.arrival_time;
    ball.flight_time = std::min(ball.flight_time, ball.arrival_time);
    return ball;
}

/// From the frame that the scene file speaks of to that of the set-up's body, which mortar may have turned.
glm::dquat turnInFrame(const Shot& shot, const SceneSetup& setup, uint32_t body) {
    const std::vector<SceneBody> places = bodiesOf(shot);
    const SceneBody& place = places[std::min<size_t>(body, places.size() - 1)];
    return setup.mortar && place.in_mortar ? turnOf(place) : glm::dquat(1, 0, 0, 0);
}

}  // namespace

bool liesFlat(const BreakableBody& body) {
    return liesFlat(boxOf(body));
}

Double3 flightDirection(const Double3& chosen, const BreakableBody& body) {
    return fromGlm(wayOf(chosen, boxOf(body)));
}

double ballRadius(const Shot& shot, const BreakableBody& body) {
    if (shot.impact.ball_radius > 0) return shot.impact.ball_radius;
    return (liesFlat(body) ? longestAcross(boxOf(body)) : heightOf(body)) / 12;
}

std::vector<TimedBall> ballsOf(const Shot& shot) {
    if (shot.impact.kind != ImpactKind::kBall || shot.impact.velocity <= 0) return {};
    if (!shot.balls.empty()) return shot.balls;
    return {ballOf(shot.impact)};
}

TimedBall fastestBall(const Shot& shot) {
    if (shot.balls.empty()) return ballOf(shot.impact);
    return *std::max_element(
        shot.balls.begin(), shot.balls.end(),
        [](const TimedBall& a, const TimedBall& b) { return a.speed_share < b.speed_share; });
}

bool dueToStart(const TimedBall& ball, double now, double step) {
    // Times are sums of steps: a flight that begins with a frame must not slip into the one after it.
    const double before_impact = ball.arrival_time - now, slack = 1e-6;
    return before_impact <= ball.flight_time + slack || before_impact - step < 0.5 * ball.flight_time;
}

ThrownBall makeBall(const Shot& shot, const SceneSetup& setup, const TimedBall& ball, double flight) {
    const BodyInstance& instance = setup.bodies[std::min<size_t>(ball.body, setup.bodies.size() - 1)];
    const BreakableBody& body = *instance.body;
    const Quaternion& q = instance.rotation;
    const glm::dquat rotation(q.w, q.x, q.y, q.z);
    const double radius = ball.radius.value_or(ballRadius(shot, body));
    const glm::dvec3 direction = wayOf(ball.direction.value_or(shot.impact.direction), boxOf(body));
    const glm::dvec3 way = glm::inverse(rotation) * direction;
    const auto height = ball.height_fraction ? ball.height_fraction : shot.impact.height_fraction;
    const glm::dvec3 aim = ball.aim ? turnInFrame(shot, setup, ball.body) * (shot.height * toGlm(*ball.aim))
                           : height ? aimPoint(body, *height)
                                    : middleSeen(body, way);
    const glm::dvec3 touch = touchPoint(body, aim, way, radius);
    const glm::dvec3 velocity = shot.impact.velocity * ball.speed_share * direction;
    return thrownFree(toGlm(instance.position) + rotation * touch, velocity, flight, radius,
                      setup.params.colliders);
}

ShotAim aimOf(const Shot& shot, const SceneBody& place, const SolidMeshInfo& body) {
    const glm::dquat turn = turnOf(place);
    ShotAim aim;
    if (shot.impact.kind == ImpactKind::kDrop) {
        const glm::dquat tilted = turn * glm::dquat(toGlm(shot.impact.tilt));
        aim.way = fromGlm(glm::inverse(tilted) * glm::dvec3(0, 1, 0));
        aim.is_wall = true;
        return aim;
    }
    const glm::dvec3 low = toGlm(body.bounds_min), box = toGlm(body.bounds_max) - low;
    const TimedBall ball = fastestBall(shot);
    aim.way = fromGlm(glm::inverse(turn) * wayOf(ball.direction.value_or(shot.impact.direction), box));
    if (ball.aim) aim.through = fromGlm(shot.height * toGlm(*ball.aim));
    const auto height = ball.height_fraction ? ball.height_fraction : shot.impact.height_fraction;
    aim.height = low.y + height.value_or(0.5) * box.y;
    return aim;
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
    return thrownFree(toGlm(target) - 1.05 * radius * direction, speed * direction, flight, radius,
                      collidersOf(shot))
        .ball;
}

}  // namespace demolish
