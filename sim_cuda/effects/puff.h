// SPDX-License-Identifier: Apache-2.0
// A puff of dust: born with a piece, perhaps carried by it for a while, slowed by the air, growing, settling
// and fading.
#pragma once
#include "sim_cuda/effects/grain.h"

namespace demolish {

struct alignas(16) Puff {
    Vec3<float> position;                     ///< m
    float age = 0;                            ///< s since it left its piece
    Vec3<float> velocity;                     ///< m/s
    float waits = 0;                          ///< s that it still stays on its piece
    float first_radius = 0, first_depth = 0;  ///< m; optical depth through the middle
    float life = 0, slowing = 1;              ///< s; s in which the air takes most of its speed
    uint32_t seed = 0, carrier = 0;           ///< the particle that it stays on
    float heat = 0;                           ///< 0: dust, 1: smoke, which rises
    uint32_t reserved = 0;
};
static_assert(sizeof(Puff) == 64);

DEM_FN bool isAlive(const Puff& puff) {
    return puff.first_radius > 0.0f && puff.age < puff.life;
}

inline constexpr float kPuffSwell = 6, kPuffSwellTime = 0.25f, kPuffGrowth = 1.2f;
/// m/s: dust is lifted at first by the air that it stirred, then it settles; smoke rises.
inline constexpr float kDustRise = 0.06f, kDustSettling = 0.05f, kDustLeast = -0.07f, kSmokeRise = 0.35f;
/// Of a puff's radius: so near to a solid its middle comes.
inline constexpr float kPuffHeight = 0.35f;
inline constexpr float kLongestWait = 0.25f;  ///< s
inline constexpr float kPuffLife = 2;         ///< s, half to one and a half of it

/// exp(-x) for x >= 0, within 0.03, by division alone.
DEM_FN float fading(float x) {
    return 1.0f / madd(x, madd(x, madd(x, 1.0f / 6.0f, 0.5f), 1.0f), 1.0f);
}

/// m: it swells fast and goes on growing slowly.
DEM_FN float radiusOf(const Puff& puff) {
    const float swollen = kPuffSwell * (1.0f - fading(puff.age / kPuffSwellTime));
    return puff.first_radius * (1.0f + swollen + kPuffGrowth * puff.age);
}

/// Optical depth through its middle.
DEM_FN float depthOf(const Puff& puff) {
    const float shown = minOf(1.0f, 0.3f + puff.age / 0.05f);
    return puff.first_depth * puff.first_radius / radiusOf(puff) * (1.0f - puff.age / puff.life) * shown;
}

DEM_FN void keepOut(Puff& puff, const TangentPlane<float>& tangent, float dt) {
    const float depth = kPuffHeight * radiusOf(puff) - tangent.distance;
    if (!(depth > 0.0f)) return;
    const Vec3<float> normal = xyz(tangent.plane);
    const float approach = -dot(puff.velocity, normal);
    if (approach > 0.0f) {  // the air spreads where it cannot go on
        const Vec3<float> along = puff.velocity + approach * normal;
        const float speed = length(along);
        puff.velocity = (speed > 1e-4f ? (speed + 0.7f * approach) / speed : 1.0f) * along;
    }
    puff.position = axpy(depth * minOf(1.0f, 8.0f * dt), normal, puff.position);
}

DEM_FN void movePuff(Puff& puff, const Surroundings& around, float dt) {
    puff.age += dt;
    const float floating = maxOf(kDustRise - kDustSettling * puff.age, kDustLeast);
    const float lift = madd(puff.heat, kSmokeRise - floating, floating);
    const Vec3<float> up = -normalized(around.gravity), air = lift * up;
    const float kept = 1.0f / (1.0f + dt / puff.slowing);
    puff.velocity = axpy(kept, puff.velocity - air, air);
    puff.position = axpy(dt, puff.velocity, puff.position);
    for (uint32_t c = 0; c < around.colliders.count; ++c)
        keepOut(puff, around.colliders.tangent(c, puff.position), dt);
}

}  // namespace demolish
