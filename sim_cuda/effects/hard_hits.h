// SPDX-License-Identifier: Apache-2.0
// What hits a floor or a collider hard, or slides over it, throws off grit and raises dust; where an iron
// ball is stopped, sparks fly and smoke rises. Hits are seen from how velocities have changed in a frame.
#pragma once
#include "sim_cuda/effects/sources.h"

namespace demolish {

/// A velocity in m/s, and 1 in w where the particle took part in the simulation.
using FormerVelocity = Vec4<float>;

inline constexpr float kHardHit = 1;       ///< m/s, along the normal: softer ones throw nothing off
inline constexpr float kMostViolence = 4;  ///< m/s above it that count
inline constexpr float kFastSlide = 0.5f;  ///< m/s
/// On h^2, of what a new face of h^2 throws off: a hit for each m/s, and sliding over a spacing.
inline constexpr float kHitGrit = 0.07f, kHitDust = 0.15f, kSlideGrit = 0.01f, kSlideDust = 0.03f;
/// Of a puff of smoke: optical depth.
inline constexpr float kSmokeDepth = 0.12f;
inline constexpr float kSparksPerSpeed = 7, kMostSparks = 120, kSmokePerSpeed = 0.5f, kMostSmoke = 6;

struct Hit {
    Vec3<float> normal;  ///< unit, out of what is hit
    Vec3<float> place;   ///< m
    float violence = 0;  ///< m/s, 0: no hit
    float slid = 0;      ///< m
    bool is_iron = false;
};

/// Particles of bodies, then projectiles.
template <class Real>
struct HitsNow {
    BodiesNow<Real> bodies;
    Span<const FormerVelocity> former;
    Span<const ParticleConstants<Real>> constants;
    Surroundings around;
    uint32_t in_bodies = 0;
    float elapsed = 0;  ///< s

    DEM_FN Hit of(uint32_t i) const {
        if (!constants[i].takesPart() || !(former[i].w > 0.0f)) return {};
        return i < in_bodies ? onCollider(i) : ofBall(i);
    }
    DEM_FN const DebrisLaw& lawOf(uint32_t i) const {
        return i < in_bodies ? bodies.lawOf(i) : bodies.law[0];
    }

  private:
    DEM_FN Vec3<float> jump(uint32_t i) const {
        return bodies.velocity(i) - xyz(former[i]) - elapsed * around.gravity;
    }
    DEM_FN Hit onCollider(uint32_t i) const {
        Hit hit;
        const Vec3<float> at = bodies.position(i), velocity = bodies.velocity(i);
        const auto reach = static_cast<float>(constants[i].floor_radius);
        for (uint32_t c = 0; c < around.colliders.count; ++c) {
            const TangentPlane<float> tangent = around.colliders.tangent(c, at);
            if (tangent.distance > 1.3f * reach) continue;
            const Vec3<float> normal = xyz(tangent.plane);
            const float kick = dot(jump(i), normal);
            if (-dot(xyz(former[i]), normal) > kHardHit && kick > kHardHit)
                hit.violence = minOf(kick - 0.7f * kHardHit, kMostViolence);
            const float speed = length(velocity - dot(velocity, normal) * normal);
            if (tangent.distance < 1.1f * reach && speed > kFastSlide) hit.slid = speed * elapsed;
            hit.normal = normal;
            hit.place = axpy(-tangent.distance, normal, at);
        }
        return hit;
    }
    /// A ball is pushed out of what it hits.
    DEM_FN Hit ofBall(uint32_t i) const {
        Hit hit;
        const Vec3<float> push = jump(i);
        const float speed = length(push);
        if (!(speed > 2.0f * kHardHit)) return hit;
        hit.is_iron = true;
        hit.violence = speed;
        hit.normal = normalized(push);
        hit.place = axpy(-static_cast<float>(constants[i].contact_radius), hit.normal, bodies.position(i));
        return hit;
    }
};

template <class Real>
struct CountOfHits {
    HitsNow<Real> hits;
    Span<uint32_t> grains, puffs;  ///< per particle and projectile
    uint64_t seed = 0;
    uint32_t frame = 0;

    DEM_FN void operator()(uint32_t i) const {
        const Hit hit = hits.of(i);
        const DebrisLaw& law = hits.lawOf(i);
        Draws draws(seed ^ 0x632be59bu, uint64_t{frame} << 32 | i);
        const float face = law.spacing * law.spacing, steps = hit.slid / law.spacing;
        float grit = law.grit_per_m2 * face * (kHitGrit * hit.violence + kSlideGrit * steps);
        float dust = law.puffs_per_m2 * face * (kHitDust * hit.violence + kSlideDust * steps);
        if (hit.is_iron) {
            grit = law.sparks * minOf(kSparksPerSpeed * hit.violence, kMostSparks);
            dust = law.puffs_per_m2 > 0.0f ? minOf(kSmokePerSpeed * hit.violence, kMostSmoke) : 0.0f;
        }
        grains[i] = draws.whole(grit);
        puffs[i] = draws.whole(dust);
    }
};

template <class Real>
struct ThrowOffHits {
    HitsNow<Real> hits;
    Births births;

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t grains = births.grainsOf(i), puffs = births.puffsOf(i);
        if (grains + puffs == 0) return;
        const Hit hit = hits.of(i);
        const Vec3<float> velocity = 0.3f * hits.bodies.velocity(i);
        for (uint32_t k = 0; k < grains; ++k) {
            const uint32_t number = births.grainNumber(i, k);
            Draws draws = births.grainDraws(number);
            births.put(number, hit.is_iron ? spark(hit, draws) : grain(i, hit, velocity, draws));
        }
        for (uint32_t k = 0; k < puffs; ++k) {
            const uint32_t number = births.puffNumber(i, k);
            Draws draws = births.puffDraws(number);
            births.put(number, hit.is_iron ? smoke(i, hit, draws) : puff(i, hit, velocity, draws));
        }
    }

  private:
    /// Along the floor rather than away from it: `rise` 0..1.
    DEM_FN static Vec3<float> spray(const Hit& hit, float rise, Draws& draws) {
        const Vec3<float> d = draws.direction();
        const float out = dot(d, hit.normal);
        return d + (rise * absOf(out) - out) * hit.normal;
    }
    DEM_FN Grain grain(uint32_t i, const Hit& hit, const Vec3<float>& velocity, Draws& draws) const {
        const DebrisLaw& law = hits.lawOf(i);
        const float size = law.spacing * sizeAt(hits.bodies.sizes.grit, draws.uniform());
        Source from{axpy(0.3f * law.spacing, draws.inBall(), hit.place), velocity};
        Grain born = thrown(from, size, law.drag, 0.0f, draws);
        const float speed = 0.5f * (hit.violence + 0.5f) * draws.uniform();
        born.velocity = axpy(speed, spray(hit, 0.6f, draws), velocity);
        return born;
    }
    DEM_FN Puff puff(uint32_t i, const Hit& hit, const Vec3<float>& velocity, Draws& draws) const {
        Puff born = raised({hit.place, {}}, hits.lawOf(i), draws);
        born.velocity = axpy(0.35f * (hit.violence + 0.3f), spray(hit, 0.25f, draws), velocity);
        born.first_depth = 0.6f * born.first_depth;
        return born;
    }
    /// Glowing iron and stone, fast and wide. Most are small, slow down in the air and are out soon.
    DEM_FN Grain spark(const Hit& hit, Draws& draws) const {
        const float share = draws.uniform(), large = share * share * share;
        Grain born = thrown({hit.place, {}}, kSparkSize * (0.4f + 1.4f * large), kSparkDrag, 0.0f, draws);
        const float speed = (0.15f + 0.65f * draws.uniform()) * minOf(hit.violence, 14.0f);
        born.velocity = speed * spray(hit, 0.8f, draws);
        born.age = births.elapsed * draws.uniform();
        born.position = axpy(born.age, born.velocity, born.position);
        born.glows = kSparkLife * (0.25f + 0.4f * draws.uniform() + 0.8f * large);
        return born;
    }
    DEM_FN Puff smoke(uint32_t i, const Hit& hit, Draws& draws) const {
        Puff born = raised({hit.place, {}}, hits.lawOf(i), draws);
        born.velocity = (0.05f * minOf(hit.violence, 10.0f)) * spray(hit, 1.0f, draws);
        born.first_depth = kSmokeDepth * (0.5f + draws.uniform());
        born.life = 1.3f * born.life;
        born.heat = 1;
        return born;
    }
};

template <class Real>
struct KeepVelocities {
    BodiesNow<Real> bodies;
    Span<const ParticleConstants<Real>> constants;
    Span<FormerVelocity> former;

    DEM_FN void operator()(uint32_t i) const {
        former[i] = withW(bodies.velocity(i), constants[i].takesPart() ? 1.0f : 0.0f);
    }
};

}  // namespace demolish
