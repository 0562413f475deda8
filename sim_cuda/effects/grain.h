// SPDX-License-Identifier: Apache-2.0
// A grain of grit, and how it flies, bounces, slides and comes to rest.
#pragma once
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/effects/draws.h"

namespace demolish {

/// Aligned, so that a GPU moves it four numbers at a time.
struct alignas(16) Grain {
    Vec3<float> position;  ///< m
    float size = 0;        ///< m, across; 0: none
    Vec3<float> velocity;  ///< m/s
    uint32_t seed = 0;     ///< of its shape and its bounces
    Quat<float> rotation;
    Vec3<float> spin;  ///< rad/s
    float age = 0;     ///< s; negative: at rest
    float drag = 0;    ///< of dragOf()
    uint32_t bounces = 0;
    float glows = 0;  ///< s for which a spark does; 0: it is grit
    uint32_t reserved = 0;
};
static_assert(sizeof(Grain) == 80);

DEM_FN bool isFlying(const Grain& grain) {
    return grain.size > 0.0f && !(grain.age < 0.0f);
}

/// What a falling grain needs to know of the scene.
struct Surroundings {
    Vec3<float> gravity;  ///< m/s^2
    ColliderSet<float> colliders;
};

/// A step is at most so long, s.
inline constexpr double kGrainStep = 1.0 / 120;
inline constexpr float kGrainBounce = 0.25f, kGrainFriction = 0.35f;
inline constexpr float kSlowBounce = 0.25f;      ///< m/s; below it a grain slides instead
inline constexpr float kSlideFriction = 6;       ///< m/s^2
inline constexpr float kGrainRestSpeed = 0.05f;  ///< m/s
/// A grain lies on the floor with its centre so high, in sizes.
inline constexpr float kGrainHeight = 0.3f;
/// s; whoever flies longer has left the scene for good.
inline constexpr float kLongestFlight = 8;

/// Of a spark: m, of dragOf() iron, s.
inline constexpr float kSparkSize = 1.2e-3f, kSparkDrag = 9e-5f, kSparkLife = 0.45f;

/// Drag is quadratic: a = -(c / size) |v| v, c = 3/4 C_d rho_air / rho of a ball with C_d = 0.8.
inline double dragOf(double density) {
    return 0.75 * 0.8 * 1.2 / density;
}

/// Velocity after dt in still air, implicitly: drag never turns it round.
DEM_FN Vec3<float> dragged(const Vec3<float>& velocity, float drag, float size, float dt) {
    return (1.0f / (1.0f + drag * length(velocity) / size * dt)) * velocity;
}

DEM_FN void bounce(Grain& grain, const Vec3<float>& normal, float approach) {
    const Vec3<float> along = grain.velocity + approach * normal;
    const float speed = length(along);
    Draws draws(grain.seed, ++grain.bounces);
    const float kept =
        maxOf(0.3f, 1.0f - kGrainFriction * (1.0f + kGrainBounce) * approach / (speed + 1e-9f));
    const float rebound = kGrainBounce * (0.5f + draws.uniform()) * approach;
    grain.velocity = kept * along + rebound * normal + (0.15f * rebound) * draws.inBall();
    grain.spin = 0.6f * grain.spin;
}

/// On a floor that is not too steep it comes to rest.
DEM_FN void slide(Grain& grain, const Vec3<float>& normal, float approach, const Vec3<float>& gravity,
                  float dt) {
    const Vec3<float> along = grain.velocity + approach * normal;
    const float speed = length(along), left = speed - kSlideFriction * dt;
    const bool flat = dot(normal, gravity) < -0.8f * length(gravity);
    if (flat && left < kGrainRestSpeed) {
        grain.velocity = {};
        grain.age = -1.0f;
        return;
    }
    const float kept = left > 0.0f ? left / speed : 0.0f;
    grain.velocity = kept * along;
    grain.spin = kept * grain.spin;
}

DEM_FN void meet(Grain& grain, const TangentPlane<float>& tangent, const Vec3<float>& gravity, float dt) {
    const float depth = kGrainHeight * grain.size - tangent.distance;
    const Vec3<float> normal = xyz(tangent.plane);
    const float approach = -dot(grain.velocity, normal);
    if (!(depth > 0.0f)) return;
    grain.position = axpy(depth, normal, grain.position);
    if (approach < 0.0f) return;
    approach > kSlowBounce ? bounce(grain, normal, approach) : slide(grain, normal, approach, gravity, dt);
}

DEM_FN void moveGrain(Grain& grain, const Surroundings& around, float dt) {
    grain.velocity = axpy(dt, around.gravity, dragged(grain.velocity, grain.drag, grain.size, dt));
    grain.position = axpy(dt, grain.velocity, grain.position);
    grain.rotation = advanced(grain.rotation, grain.spin, dt);
    grain.age += dt;
    if (grain.age > (grain.glows > 0.0f ? grain.glows : kLongestFlight)) grain.size = 0.0f;
    for (uint32_t c = 0; c < around.colliders.count && isFlying(grain); ++c)
        meet(grain, around.colliders.tangent(c, grain.position), around.gravity, dt);
    if (grain.glows > 0.0f && !isFlying(grain)) grain.size = 0.0f;  // a spark that lies is out
}

}  // namespace demolish
