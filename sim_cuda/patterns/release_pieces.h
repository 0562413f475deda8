// SPDX-License-Identifier: Apache-2.0
// Bodies come apart into the pieces of their pattern:
//
//   first touch of each body -> which come apart now -> where it is touched -> how the pattern lies
//   -> piece of each particle -> bonds between pieces
//
// The first touch is the least word, and of several the lowest particle: the same on every device.
#pragma once
#include "sim_cuda/patterns/hard_touch.h"
#include "sim_cuda/patterns/piece_pattern.h"

namespace demolish {

/// What the host wants to know: 1 if some body comes apart; earliest touch of the others, as a word.
inline constexpr uint32_t kSplitsNow = 0, kNextTouch = 1, kPresetWords = 2;
inline constexpr uint32_t kNoTouch = 0xffffffffu;

/// One thread a particle of a body.
template <class Real>
struct ForeseeTouches {
    HardTouches<Real> touches;
    Span<const uint32_t> released;  ///< per body: 1 of those that have come apart
    Span<uint32_t> first;           ///< per body, kNoTouch before: time of its first touch, as a word

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t body = touches.rules.meetings.owner[i];
        if (released[body] != 0) return;
        const uint32_t word = wordOfTime(touches.of(i).time);
        if (word < atomicLoadU32(&first[body])) atomicMinU32(&first[body], word);
    }
};

/// One thread a body.
struct ChooseSplits {
    Span<const uint32_t> first;
    uint32_t within = 0;  ///< s, as a word: who is touched by then comes apart now
    Span<uint32_t> released, splits;
    Span<uint32_t> words;  ///< kPresetWords, as none is touched

    DEM_FN void operator()(uint32_t body) const {
        splits[body] = 0;
        if (released[body] != 0) return;
        if (first[body] > within) {
            atomicMinU32(&words[kNextTouch], first[body]);
            return;
        }
        splits[body] = released[body] = 1;
        atomicOrU32(&words[kSplitsNow], 1u);
    }
};

/// One thread a particle of a body.
template <class Real>
struct FindStruck {
    HardTouches<Real> touches;
    Span<const uint32_t> splits, first;
    Span<uint32_t> struck;  ///< per body, kNoTouch before: the particle that is touched first

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t body = touches.rules.meetings.owner[i];
        if (splits[body] != 0 && wordOfTime(touches.of(i).time) == first[body])
            atomicMinU32(&struck[body], i);
    }
};

/// One thread a body: its pattern is turned to what touches it first.
template <class Real>
struct TurnPatterns {
    HardTouches<Real> touches;
    Span<const uint32_t> splits, struck;
    Span<const Vec4<float>> rest;  ///< m, per particle of a body
    Span<PatternFrame> frame;

    DEM_FN void operator()(uint32_t body) const {
        if (splits[body] == 0) return;
        const uint32_t i = struck[body];
        const Vec4<Real> q = touches.rules.meetings.state.rotation[i];
        const Vec3<Real> way = rotate(conjugate(Quat<Real>{q.x, q.y, q.z, q.w}), touches.of(i).approach);
        frame[body] =
            patternFrame(xyz(rest[i]), normalized(Vec3<float>{float(way.x), float(way.y), float(way.z)}));
    }
};

/// One thread a particle of a body.
struct CutPieces {
    Span<const uint32_t> owner, splits;
    Span<const PiecePattern> pattern;  ///< per body, as the next
    Span<const PatternFrame> frame;
    Span<const Vec4<float>> rest;
    Span<uint32_t> piece;

    DEM_FN void operator()(uint32_t i) const {
        const uint32_t body = owner[i];
        if (splits[body] != 0) piece[i] = pieceAt(pattern[body], frame[body], xyz(rest[i]));
    }
};

/// One thread a particle of a body. Nothing is strained in a body whose bonds are never stepped: no energy
/// leaves with them.
struct ReleaseBonds {
    Span<const uint32_t> owner, splits, piece;
    Span<const uint32_t> row_start;
    Span<BondLink> link;

    DEM_FN void operator()(uint32_t i) const {
        if (splits[owner[i]] == 0) return;
        for (uint32_t slot = row_start[i]; slot < row_start[i + 1]; ++slot) {
            const uint32_t j = linkedParticle(link[slot]);
            if (isBonded(link[slot]) && piece[i] != piece[j])
                link[slot].link = linkWord(j, PairState::kBroken);
        }
    }
};

}  // namespace demolish
