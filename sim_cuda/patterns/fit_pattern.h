// SPDX-License-Identifier: Apache-2.0
// How large pieces have to be for a body to come apart into as many as are asked for: its surface cuts pieces
// of a pattern in two, and a thin wall has few whole ones, so that volumes alone do not tell.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "sim_cuda/data/vec4.h"
#include "sim_cuda/patterns/piece_pattern.h"

namespace demolish {

/// Pieces that have a particle. rest: m, in the body's frame.
inline size_t countPieces(const PiecePattern& pattern, const PatternFrame& frame,
                          std::span<const Vec4<float>> rest) {
    std::vector<uint32_t> words(rest.size());
    std::transform(rest.begin(), rest.end(), words.begin(),
                   [&](const Vec4<float>& place) { return pieceAt(pattern, frame, xyz(place)); });
    std::sort(words.begin(), words.end());
    return static_cast<size_t>(std::unique(words.begin(), words.end()) - words.begin());
}

/// The pattern with the size by which countPieces() comes nearest to `pieces`, from its own size as a guess.
/// Numbers fall with sizes, but not evenly: of the sizes that a bisection meets, the best. Square roots and
/// no logarithms, which differ between machines. One piece is of endless size: the middle of a pattern is
/// where pieces meet, so that a body about it would be cut by pieces of any other size.
inline PiecePattern fittedPattern(const PiecePattern& guess, const PatternFrame& frame,
                                  std::span<const Vec4<float>> rest, uint32_t pieces) {
    constexpr int kLooks = 9;
    float finer = 0.25f, coarser = 16;  // times the guess
    double best_miss = 1e30;
    PiecePattern best = guess, pattern = guess;
    if (pieces <= 1) {
        best.size = std::numeric_limits<float>::infinity();
        return best;
    }
    for (int look = 0; look < kLooks; ++look) {
        const float middle = std::sqrt(finer * coarser);
        pattern.size = middle * guess.size;
        const size_t count = countPieces(pattern, frame, rest);
        (count > pieces ? finer : coarser) = middle;
        const double share = static_cast<double>(count) / pieces, miss = std::max(share, 1 / share);
        if (!(miss < best_miss)) continue;
        best_miss = miss;
        best = pattern;
    }
    return best;
}

}  // namespace demolish
