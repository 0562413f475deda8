// SPDX-License-Identifier: Apache-2.0
// Where what is born is kept: the one with birth number b stands at b modulo the room, so that the oldest
// makes room, and nothing is ever moved or sorted.
#pragma once
#include "sim_cuda/effects/puff.h"

namespace demolish {

/// Births so far, by kind: one word each in device memory.
inline constexpr uint32_t kGrainBirths = 0, kPuffBirths = 1, kSparkBirths = 2, kBirthWords = 4;

template <class T>
struct Ring {
    Span<T> slot;

    /// `number` of `last` births: those who would be overwritten in the same frame are left out.
    DEM_FN void put(uint32_t number, uint32_t last, const T& value) const {
        if (last - number <= slot.size()) slot[number % slot.size()] = value;
    }
};

/// What is born while a kernel runs.
struct Births {
    Ring<Grain> grains;
    Ring<Puff> puffs;
    Span<const uint32_t> before;                   ///< kBirthWords
    Span<const uint32_t> first_grain, first_puff;  ///< per source, exclusive sums; one longer than those
    uint64_t seed = 0;
    float elapsed = 0;  ///< s, of the frame

    DEM_FN uint32_t grainsOf(uint32_t source) const { return first_grain[source + 1] - first_grain[source]; }
    DEM_FN uint32_t puffsOf(uint32_t source) const { return first_puff[source + 1] - first_puff[source]; }
    DEM_FN uint32_t grainNumber(uint32_t source, uint32_t k) const {
        return before[kGrainBirths] + first_grain[source] + k;
    }
    DEM_FN uint32_t puffNumber(uint32_t source, uint32_t k) const {
        return before[kPuffBirths] + first_puff[source] + k;
    }
    DEM_FN void put(uint32_t number, const Grain& grain) const {
        grains.put(number, before[kGrainBirths] + first_grain[first_grain.size() - 1], grain);
    }
    DEM_FN void put(uint32_t number, const Puff& puff) const {
        puffs.put(number, before[kPuffBirths] + first_puff[first_puff.size() - 1], puff);
    }
    DEM_FN Draws grainDraws(uint32_t number) const { return Draws(seed, number); }
    DEM_FN Draws puffDraws(uint32_t number) const { return Draws(~seed, number); }
};

/// After the births of a kernel's sources.
struct CountBirths {
    Span<const uint32_t> first_grain, first_puff;
    Span<uint32_t> births;

    DEM_FN void operator()(uint32_t) const {
        births[kGrainBirths] += first_grain[first_grain.size() - 1];
        births[kPuffBirths] += first_puff[first_puff.size() - 1];
    }
};

}  // namespace demolish
