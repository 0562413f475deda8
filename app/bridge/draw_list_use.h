// SPDX-License-Identifier: Apache-2.0
// How much of the draw lists is in use.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sim_cuda/api/render_streams.h"

namespace demolish {

struct DrawListUse {
    size_t interior_indices = 0, interior_vertices = 0, exterior_indices = 0;  ///< elements
};
/// Of the outside, from the first that was written to the last.
struct WrittenVertices {
    size_t first = 0, count = 0;
};
inline WrittenVertices writtenVertices(std::span<const uint32_t> chunks, size_t vertices) {
    const auto written = [](uint32_t chunk) { return chunk != 0; };
    const auto first = std::find_if(chunks.begin(), chunks.end(), written);
    if (first == chunks.end()) return {};
    const auto last = std::find_if(chunks.rbegin(), chunks.rend(), written);
    const size_t begin = kExteriorChunk * static_cast<size_t>(first - chunks.begin());
    const size_t end = kExteriorChunk * static_cast<size_t>(chunks.rend() - last);
    return {begin, std::min(end, vertices) - begin};
}

/// Vertices in use follow from the highest index.
inline DrawListUse drawListUse(const DrawCommands& commands, std::span<const uint32_t> interior_indices) {
    DrawListUse use;
    use.interior_indices = std::min<size_t>(commands.interior.count, interior_indices.size());
    const auto used = interior_indices.first(use.interior_indices);
    if (!used.empty()) use.interior_vertices = *std::max_element(used.begin(), used.end()) + size_t{1};
    use.exterior_indices = commands.exterior.count;
    return use;
}

}  // namespace demolish
