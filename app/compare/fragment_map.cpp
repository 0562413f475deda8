// SPDX-License-Identifier: Apache-2.0
#include "app/compare/fragment_map.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace demolish {
namespace {

double pairsOf(double count) {
    return count * (count - 1) / 2;
}

double pairsWithin(const std::vector<uint32_t>& sizes) {
    double pairs = 0;
    for (const uint32_t size : sizes) pairs += pairsOf(size);
    return pairs;
}

}  // namespace

std::vector<uint32_t> cellsOfPieces(std::span<const uint32_t> map) {
    std::vector<uint32_t> cells(map.empty() ? 0 : *std::max_element(map.begin(), map.end()) + size_t{1});
    for (const uint32_t piece : map) ++cells[piece];
    return cells;
}

double mapDistance(std::span<const uint32_t> a, std::span<const uint32_t> b) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> shared;
    for (size_t i = 0; i < a.size(); ++i) ++shared[{a[i], b[i]}];
    double together = 0;
    for (const auto& [pieces, cells] : shared) together += pairsOf(cells);
    const double in_a = pairsWithin(cellsOfPieces(a)), in_b = pairsWithin(cellsOfPieces(b));
    const double all = pairsOf(static_cast<double>(a.size()));
    const double by_chance = all > 0 ? in_a * in_b / all : 0, most = (in_a + in_b) / 2;
    return most > by_chance ? 1 - (together - by_chance) / (most - by_chance) : 0;
}

PieceSizes pieceSizes(std::span<const uint32_t> map) {
    std::vector<uint32_t> cells = cellsOfPieces(map);
    std::sort(cells.begin(), cells.end(), std::greater<>());
    PieceSizes sizes;
    size_t sum = 0;
    for (const uint32_t count : cells) {
        if (count == 0) break;
        ++sizes.pieces;
        if (count == 1) ++sizes.single;
        if (2 * sum < map.size()) ++sizes.half;
        sum += count;
    }
    sizes.largest = map.empty() ? 0 : static_cast<double>(cells[0]) / static_cast<double>(map.size());
    return sizes;
}

}  // namespace demolish
