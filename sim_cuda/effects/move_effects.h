// SPDX-License-Identifier: Apache-2.0
// A frame in the life of grains and puffs.
#pragma once
#include "sim_cuda/effects/sources.h"

namespace demolish {

struct MoveGrains {
    Span<Grain> grains;
    Surroundings around;
    uint32_t steps = 1;
    float dt = 0;  ///< s

    DEM_FN void operator()(uint32_t slot) const {
        Grain grain = grains[slot];
        if (!isFlying(grain)) return;
        for (uint32_t k = 0; k < steps && isFlying(grain); ++k) moveGrain(grain, around, dt);
        grains[slot] = grain;
    }
};

template <class Real>
struct MovePuffs {
    BodiesNow<Real> bodies;
    Span<Puff> puffs;
    Surroundings around;
    uint32_t steps = 1;
    float dt = 0;  ///< s

    DEM_FN void operator()(uint32_t slot) const {
        Puff puff = puffs[slot];
        if (!isAlive(puff)) return;
        if (puff.waits > 0.0f)
            stay(puff);
        else
            for (uint32_t k = 0; k < steps; ++k) movePuff(puff, around, dt);
        puffs[slot] = puff;
    }

  private:
    /// It goes with its piece, and is left behind at last.
    DEM_FN void stay(Puff& puff) const {
        puff.position = bodies.position(puff.carrier);
        puff.waits -= static_cast<float>(steps) * dt;
        if (puff.waits > 0.0f) return;
        Draws draws(puff.seed, puff.carrier);
        const Vec3<float> velocity = bodies.velocity(puff.carrier);
        puff.velocity = 0.35f * velocity + (0.15f + 0.08f * length(velocity)) * draws.inBall();
    }
};

}  // namespace demolish
