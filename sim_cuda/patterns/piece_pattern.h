// SPDX-License-Identifier: Apache-2.0
// Patterns of pieces as functions of the place at rest: two places are of one piece where their words agree.
// Only + - x / and square roots, so that every device cuts the same pieces.
#pragma once
#include "sim_cuda/api/params.h"
#include "sim_cuda/physics/value_noise.h"

namespace demolish {

/// How a pattern lies in a body.
struct PatternFrame {
    Vec3<float> centre;               ///< m, in the body's frame at rest
    Vec3<float> across, along, axis;  ///< unit, at right angles to each other
};

/// Some frame with this axis (unit), by the branchless construction of Duff et al. 2017 (JCGT 6, 1).
DEM_FN PatternFrame patternFrame(const Vec3<float>& centre, const Vec3<float>& axis) {
    const float sign = axis.z < 0.0f ? -1.0f : 1.0f, a = -1.0f / (sign + axis.z), b = axis.x * axis.y * a;
    return {centre,
            {1.0f + sign * axis.x * axis.x * a, sign * b, -sign * axis.x},
            {b, sign + axis.y * axis.y * a, -axis.y},
            axis};
}

struct PiecePattern {
    Pattern kind = Pattern::kUniform;
    float size = 1;     ///< m, of the mean piece; infinity: all is one
    uint32_t seed = 0;  ///< of the places of pieces
};

/// Cuts are bent by noise of this amplitude and wavelength, in sizes of a piece: else they look sawn.
inline constexpr float kCutBend = 0.09f, kBendWave = 0.8f;
/// Sites of pieces lie within so much of the middle of their lattice cell, in edges of it.
inline constexpr float kSiteJitter = 0.42f;
/// Radial pieces at the centre are smaller by the first; at the second, in sizes, twice as wide as there.
inline constexpr float kRadialFineness = 2.0f, kRadialGrowth = 2.0f, kRadialLayer = 2.2f;
/// Extents of the others, in sizes of a piece; the product of each three is about 1.
inline constexpr float kSlab = 0.8f;
inline constexpr float kBrickLength = 1.6f, kBrickWidth = 0.8f, kBrickHeight = 0.8f;
inline constexpr float kSplinterWidth = 0.58f, kSplinterLength = 3.0f;

DEM_FN int32_t wholeBelow(float v) {
    const int32_t whole = static_cast<int32_t>(v);
    return static_cast<float>(whole) > v ? whole - 1 : whole;
}
/// Ten bits of each: lattices of more than 1,024 cells along an edge begin anew.
DEM_FN uint32_t latticeWord(int32_t x, int32_t y, int32_t z) {
    return (static_cast<uint32_t>(x) & 1023u) | (static_cast<uint32_t>(y) & 1023u) << 10 |
           (static_cast<uint32_t>(z) & 1023u) << 20;
}

/// Cell of the cubic lattice of edge 1 whose site is nearest to p.
DEM_FN uint32_t nearestSite(const Vec3<float>& p, uint32_t seed) {
    const int32_t x = wholeBelow(p.x), y = wholeBelow(p.y), z = wholeBelow(p.z);
    uint32_t nearest = 0;
    float least = 1e30f;
    for (int32_t k = 0; k < 27; ++k) {
        const int32_t i = x + k % 3 - 1, j = y + k / 3 % 3 - 1, l = z + k / 9 - 1;
        const Vec3<float> middle{static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f,
                                 static_cast<float>(l) + 0.5f};
        const float distance2 = length2(axpy(kSiteJitter, latticeVector(i, j, l, seed), middle) - p);
        if (!(distance2 < least)) continue;
        least = distance2;
        nearest = latticeWord(i, j, l);
    }
    return nearest;
}

/// The middle of a word's lattice cell along one edge.
DEM_FN float middleOf(uint32_t word, uint32_t shift) {
    return static_cast<float>(static_cast<int32_t>((word >> shift & 1023u) ^ 512u) - 512) + 0.5f;
}
/// Squared, from the site of the word's cell.
DEM_FN float farFromSite(const Vec3<float>& p, uint32_t word, uint32_t seed) {
    const Vec3<float> middle{middleOf(word, 0), middleOf(word, 10), middleOf(word, 20)};
    const Vec3<float> jitter =
        latticeVector(wholeBelow(middle.x), wholeBelow(middle.y), wholeBelow(middle.z), seed);
    return length2(axpy(kSiteJitter, jitter, middle) - p);
}

/// The others take p in sizes of a piece, in the pattern's frame. Courses are half a brick against each
/// other.
DEM_FN float brickShift(int32_t course) {
    return (course & 1) != 0 ? 0.5f : 0.0f;
}
DEM_FN uint32_t brickAt(const Vec3<float>& p) {
    const int32_t course = wholeBelow(p.z / kBrickHeight);
    return latticeWord(wholeBelow(p.x / kBrickLength + brickShift(course)), wholeBelow(p.y / kBrickWidth),
                       course);
}
/// The largest of the three shares of a brick.
DEM_FN float farFromBrick(const Vec3<float>& p, uint32_t word) {
    const float course = middleOf(word, 20), up = absOf(p.z / kBrickHeight - course);
    const float along = absOf(p.x / kBrickLength + brickShift(wholeBelow(course)) - middleOf(word, 0)),
                across = absOf(p.y / kBrickWidth - middleOf(word, 10));
    return maxOf(up, maxOf(along, across));
}
/// Where radial pieces and splinters are round and of size 1.
DEM_FN Vec3<float> radialPlace(const Vec3<float>& p) {
    const float far = squareRoot(p.x * p.x + p.y * p.y);
    const float scale = kRadialFineness / (1.0f + far / kRadialGrowth);
    return {scale * p.x, scale * p.y, p.z / kRadialLayer};
}
DEM_FN Vec3<float> splinterPlace(const Vec3<float>& p) {
    return {p.x / kSplinterWidth, p.y / kSplinterWidth, p.z / kSplinterLength};
}

/// rest: m, in the body's frame. In sizes of a piece, in the pattern's frame, bent as the cuts are.
DEM_FN Vec3<float> bentPlace(const PiecePattern& pattern, const PatternFrame& frame,
                             const Vec3<float>& rest) {
    const Vec3<float> from = (1.0f / pattern.size) * (rest - frame.centre);
    const Vec3<float> straight{dot(from, frame.across), dot(from, frame.along), dot(from, frame.axis)};
    return axpy(kCutBend, valueNoise((1.0f / kBendWave) * straight, ~pattern.seed), straight);
}

/// A word for the piece that the place belongs to; rest: m, in the body's frame.
DEM_FN uint32_t pieceAt(const PiecePattern& pattern, const PatternFrame& frame, const Vec3<float>& rest) {
    const Vec3<float> p = bentPlace(pattern, frame, rest);
    switch (pattern.kind) {
        case Pattern::kUniform:
            break;
        case Pattern::kRadial:
            return nearestSite(radialPlace(p), pattern.seed);
        case Pattern::kSlabs:
            return latticeWord(0, 0, wholeBelow(p.z / kSlab));
        case Pattern::kBricks:
            return brickAt(p);
        case Pattern::kSplinters:
            return nearestSite(splinterPlace(p), pattern.seed);
    }
    return nearestSite(p, pattern.seed);
}

/// How far a bent place is from the middle of a piece, in a measure by which it is of the nearest one: of two
/// neighbours both are as far where they meet.
DEM_FN float farFromPiece(const PiecePattern& pattern, const Vec3<float>& p, uint32_t word) {
    switch (pattern.kind) {
        case Pattern::kUniform:
            break;
        case Pattern::kRadial:
            return farFromSite(radialPlace(p), word, pattern.seed);
        case Pattern::kSlabs:
            return absOf(p.z / kSlab - middleOf(word, 20));
        case Pattern::kBricks:
            return farFromBrick(p, word);
        case Pattern::kSplinters:
            return farFromSite(splinterPlace(p), word, pattern.seed);
    }
    return farFromSite(p, word, pattern.seed);
}

}  // namespace demolish
