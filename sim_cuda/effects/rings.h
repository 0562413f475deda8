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

/// Places that throw off debris in a frame, kind after kind: faces, cells, hits.
struct SourceCounts {
    uint32_t faces = 0, cells = 0, hits = 0;

    DEM_FN uint32_t all() const { return faces + cells + hits; }
    DEM_FN uint32_t firstCell() const { return faces; }
    DEM_FN uint32_t firstHit() const { return faces + cells; }
};

/// What is born in a frame, as the sources of one kind see it.
struct Births {
    Ring<Grain> grains;
    Ring<Puff> puffs;
    Span<const uint32_t> before;  ///< kBirthWords
    /// Exclusive sums of the grains of all sources of the frame, then on of their puffs, and the total.
    Span<const uint32_t> sums;
    uint32_t all = 0, first = 0;  ///< sources of the frame; number of the first one of this kind
    uint64_t seed = 0;
    float elapsed = 0;  ///< s, of the frame

    DEM_FN uint32_t allGrains() const { return sums[all]; }
    DEM_FN uint32_t allPuffs() const { return sums[2 * all] - sums[all]; }
    DEM_FN uint32_t grainsOf(uint32_t source) const { return born(first + source); }
    DEM_FN uint32_t puffsOf(uint32_t source) const { return born(all + first + source); }
    DEM_FN uint32_t grainNumber(uint32_t source, uint32_t k) const {
        return before[kGrainBirths] + sums[first + source] + k;
    }
    DEM_FN uint32_t puffNumber(uint32_t source, uint32_t k) const {
        return before[kPuffBirths] + (sums[all + first + source] - sums[all]) + k;
    }
    DEM_FN void put(uint32_t number, const Grain& grain) const {
        grains.put(number, before[kGrainBirths] + allGrains(), grain);
    }
    DEM_FN void put(uint32_t number, const Puff& puff) const {
        puffs.put(number, before[kPuffBirths] + allPuffs(), puff);
    }
    DEM_FN Draws grainDraws(uint32_t number) const { return Draws(seed, number); }
    DEM_FN Draws puffDraws(uint32_t number) const { return Draws(~seed, number); }

  private:
    DEM_FN uint32_t born(uint32_t place) const { return sums[place + 1] - sums[place]; }
};

/// After the births of a frame.
struct CountBirths {
    Births born;
    Span<uint32_t> births;

    DEM_FN void operator()(uint32_t) const {
        births[kGrainBirths] += born.allGrains();
        births[kPuffBirths] += born.allPuffs();
    }
};

}  // namespace demolish
