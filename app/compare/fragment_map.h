// SPDX-License-Identifier: Apache-2.0
// Which cell belongs to which piece: what two of such maps have in common, and how large the pieces are.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace demolish {

/// 1 - ARI, the adjusted Rand index of Hubert and Arabie (1985) over pairs of cells: 0 where both maps make
/// the same pieces, about 1 where they have no more in common than chance. Names of pieces do not matter;
/// both maps are of the same cells. 0 where neither has anything apart.
double mapDistance(std::span<const uint32_t> a, std::span<const uint32_t> b);

struct PieceSizes {
    size_t pieces = 0;
    size_t single = 0;   ///< of one cell
    double largest = 0;  ///< share of the cells
    size_t half = 0;     ///< the largest pieces that together hold half of the cells
};
PieceSizes pieceSizes(std::span<const uint32_t> map);

/// Cells of each piece, by the pieces' names.
std::vector<uint32_t> cellsOfPieces(std::span<const uint32_t> map);

}  // namespace demolish
