// One pass of a stable sort of ids by a digit of their keys: count digits chunk by chunk, then, after a scan,
// put each id in its place in the order in which it came.
#pragma once
#include "sim_cuda/backend/span.h"
#include "sim_cuda/physics/scalar.h"

namespace demolish {

inline constexpr uint32_t kDigitBits = 6, kDigits = 1u << kDigitBits, kSortChunk = 64;

struct CountDigits {
    Span<const uint32_t> order, key;  ///< ids; key of each id
    uint32_t shift = 0, chunks = 0;
    Span<uint32_t> count;  ///< digit by digit, chunk by chunk within

    DEM_FN void operator()(uint32_t chunk) const {
        uint32_t counts[kDigits] = {};
        const uint32_t first = chunk * kSortChunk, n = static_cast<uint32_t>(order.size());
        const uint32_t last = minOf(first + kSortChunk, n);
        for (uint32_t at = first; at < last; ++at) ++counts[key[order[at]] >> shift & (kDigits - 1)];
        for (uint32_t digit = 0; digit < kDigits; ++digit) count[digit * chunks + chunk] = counts[digit];
    }
};

struct PlaceDigits {
    Span<const uint32_t> order, key;
    Span<const uint32_t> start;  ///< exclusive sums of the counts
    uint32_t shift = 0, chunks = 0;
    Span<uint32_t> sorted;

    DEM_FN void operator()(uint32_t chunk) const {
        uint32_t place[kDigits];
        for (uint32_t digit = 0; digit < kDigits; ++digit) place[digit] = start[digit * chunks + chunk];
        const uint32_t first = chunk * kSortChunk, n = static_cast<uint32_t>(order.size());
        const uint32_t last = minOf(first + kSortChunk, n);
        for (uint32_t at = first; at < last; ++at) {
            const uint32_t id = order[at];
            sorted[place[key[id] >> shift & (kDigits - 1)]++] = id;
        }
    }
};

}  // namespace demolish
