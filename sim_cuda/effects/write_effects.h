// SPDX-License-Identifier: Apache-2.0
// Grains and puffs as they are drawn.
#pragma once
#include <bit>

#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/effects/rings.h"
#include "sim_cuda/physics/vertex_packing.h"

namespace demolish {

/// x in the low half; -1..1 each.
DEM_FN uint32_t packPair(float x, float y) {
    const auto word = [](float v) {
        const float scaled = 32767.0f * clampTo(v, -1.0f, 1.0f);
        return static_cast<uint32_t>(static_cast<int32_t>(scaled < 0.0f ? scaled - 0.5f : scaled + 0.5f)) &
               0xffffu;
    };
    return word(x) | word(y) << 16;
}

DEM_FN GrainInstance instanceOf(const Grain& grain) {
    const Quat<float>& q = grain.rotation;
    const Vec3<float>& v = grain.velocity;
    const bool glows = grain.glows > 0.0f;
    return {{grain.position.x, grain.position.y, grain.position.z},
            grain.size,
            {glows ? packHalf2(v.x, v.y) : packPair(q.x, q.y),
             glows ? packHalf2(v.z, grain.age) : packPair(q.z, q.w)},
            grain.seed,
            glows ? maxOf(1.0f - grain.age / grain.glows, 1e-3f) : 0.0f};
}

/// Those that still wait on their piece are not seen.
DEM_FN PuffInstance instanceOf(const Puff& puff) {
    const bool seen = isAlive(puff) && !(puff.waits > 0.0f);
    return {{puff.position.x, puff.position.y, puff.position.z},
            seen ? radiusOf(puff) : 0.0f,
            seen ? depthOf(puff) : 0.0f,
            puff.age,
            puff.seed,
            puff.heat};
}

template <class T, class Instance>
struct WriteInstances {
    Span<const T> from;
    Span<Instance> to;

    DEM_FN void operator()(uint32_t slot) const {
        if (slot < to.size()) to[slot] = instanceOf(from[slot]);
    }
};

struct WriteEffectCommands {
    Span<const uint32_t> births;
    uint32_t grain_room = 0, puff_room = 0;
    Span<EffectCommands> commands;

    DEM_FN void operator()(uint32_t) const {
        const uint32_t grains = minOf(births[kGrainBirths], grain_room);
        const uint32_t puffs = minOf(births[kPuffBirths], puff_room);
        commands[0] = effectCommands(grains, puffs);
    }
};

/// Adds up the bits of what is drawn, each slot with its place.
template <class T>
struct HashInstances {
    Span<const T> from;
    uint64_t seed = 0;
    Span<uint64_t> sum;

    DEM_FN void operator()(uint32_t slot) const {
        struct Words {
            uint32_t word[8];
        };
        const auto words = std::bit_cast<Words>(instanceOf(from[slot]));
        uint64_t hash = counterHash(seed, slot);
        for (const uint32_t word : words.word) hash = counterHash(hash, word);
        atomicAddU64(&sum[0], hash);
    }
};

}  // namespace demolish
