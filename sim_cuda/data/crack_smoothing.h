// SPDX-License-Identifier: Apache-2.0
// How much a crack is smoothed where it bounds a piece of so many cells: large pieces have long lines and
// even faces, crumbs stay angular. Chosen by eye and by the measures of docs/looks.md 4.
#pragma once
#include <cstdint>

#include "sim_cuda/physics/scalar.h"

namespace demolish {

/// Of one kind of piece; lengths over h.
struct CrackSmoothing {
    float line;      ///< sigma along the line of a crack on the outside
    uint32_t steps;  ///< Laplacian steps on its face
    float limit;     ///< how far these move a vertex
    float rough;     ///< amplitude of the roughness laid over it
    float waves;     ///< share of the material's waves, on line and face
};

inline constexpr uint32_t kMostSmoothingSteps = 30;
inline constexpr float kRoughness = 0.05f, kPlaneRoughness = 0.02f, kRoughnessWave = 0.6f,
                       kSmoothingLimit = 0.7f;

/// Pieces of so few cells are drawn as these are.
inline constexpr uint32_t kMostCellsOfCrumb = 1;
/// Up to so many, pieces are drawn with flat faces and sharp edges.
inline constexpr uint32_t kMostCellsPlaned = 16;
/// So are those of more than a crumb, and their vertices go to a few planes (plane_pieces.h).
DEM_FN bool isPlaned(uint32_t cells) {
    return cells > kMostCellsOfCrumb && cells <= kMostCellsPlaned;
}
/// h: limit for what also bounds a crumb. A crater is no mould of what broke out of it, but a crumb must not
/// be pressed flat.
inline constexpr float kLimitAtCrumb = 0.35f;

inline constexpr uint32_t kNoPiece = 0xffffffffu;

/// The pieces that meet at a vertex of the crack.
struct PiecesThere {
    uint32_t smallest = 0;     ///< cells, crumbs left out; 0: none but crumbs
    uint32_t slot = kNoPiece;  ///< of it; of equal ones the lowest
    bool crumb = false;        ///< there is one

    DEM_FN void add(uint32_t cells, uint32_t at) {
        const bool is_crumb = cells <= kMostCellsOfCrumb;
        crumb = crumb || is_crumb;
        if (is_crumb) return;
        if (smallest == 0 || cells < smallest || (cells == smallest && at < slot)) {
            smallest = cells;
            slot = at;
        }
    }
    static constexpr uint32_t kCrumbBit = 1u << 31;
    DEM_FN uint32_t word() const { return smallest | (crumb ? kCrumbBit : 0); }
};

/// `cells`: of the smallest piece that the crack bounds there.
DEM_FN CrackSmoothing crackSmoothing(uint32_t cells) {
    if (cells <= 1) return {0.0f, 0, 0.0f, 0.0f, 0.0f};
    if (cells <= 4) return {0.3f, 2, 0.2f, kPlaneRoughness, 0.0f};
    if (cells <= kMostCellsPlaned) return {0.5f, 5, 0.35f, kPlaneRoughness, 0.0f};
    if (cells <= 30) return {0.8f, 12, 0.5f, kRoughness, 0.6f};
    return {1.1f, kMostSmoothingSteps, kSmoothingLimit, kRoughness, 1.0f};
}
/// `pieces`: PiecesThere::word().
DEM_FN CrackSmoothing faceSmoothing(uint32_t pieces) {
    CrackSmoothing smoothing = crackSmoothing(pieces & ~PiecesThere::kCrumbBit);
    if ((pieces & PiecesThere::kCrumbBit) != 0 && smoothing.limit > kLimitAtCrumb)
        smoothing.limit = kLimitAtCrumb;
    return smoothing;
}

/// A Gaussian's stand-in without exp(): (1 - x^2)^3 for the share x of the way to where it ends, which is at
/// kLineReach sigmas.
inline constexpr float kLineReach = 2.5f;
DEM_FN float bump(float x) {
    const float rest = 1.0f - x * x;
    return x < 1.0f ? rest * rest * rest : 0.0f;
}
/// 0 at 0, 1 from 1 on, flat at both ends.
DEM_FN float smoothStep(float x) {
    const float t = clampTo(x, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

}  // namespace demolish
