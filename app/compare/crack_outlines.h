// SPDX-License-Identifier: Apache-2.0
// Where the outside of a broken body is cut between large pieces, as lines.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "app/compare/crack_lines.h"
#include "sim_cuda/api/fracture_geometry.h"

namespace demolish {

/// Pieces of fewer cells are not large.
inline constexpr uint32_t kLargePiece = 30;

/// Borders between large pieces, cut where lines meet. outside: the exterior's vertices as drawn, or at rest;
/// fragment: of each cell; size: cells of each fragment.
std::vector<Line> crackOutlines(const FractureGeometry& geometry, std::span<const SurfaceVertex> outside,
                                std::span<const uint32_t> fragment, std::span<const uint32_t> size);

}  // namespace demolish
