// SPDX-License-Identifier: Apache-2.0
// How a substep is spread over the threads of a GPU, by how many particles it moves.
#pragma once
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace demolish {

/// Threads that share a particle, and whether another one moves it (substep_cuda.cuh).
struct SubstepWidth {
    uint32_t threads = 0;
    bool moves_apart = true;
    bool operator==(const SubstepWidth&) const = default;
};
inline constexpr struct {
    std::string_view name;
    SubstepWidth width;
    uint32_t from;  ///< particles; measured on an H200 and an H100 from 2k to 1000k
} kSubstepWidths[] = {
    {"16", {16}, 0}, {"8", {8}, 4'000}, {"4", {4}, 16'000}, {"4-alone", {4, false}, 90'000}};

/// DEMOLISH_THREADS_PER_PARTICLE (a name) overrides it, for measurements; every choice gives the same bits.
inline SubstepWidth substepWidth(uint32_t particles) {
    const char* wish = std::getenv("DEMOLISH_THREADS_PER_PARTICLE");
    SubstepWidth last;
    for (const auto& [name, width, from] : kSubstepWidths) {
        if (wish != nullptr && name == wish) return width;
        if (from <= particles) last = width;
    }
    return last;
}
/// visit(width) for all that are chosen for up to so many particles.
template <class Visit>
void forEachWidth(uint32_t particles, const Visit& visit) {
    SubstepWidth last;
    for (const auto& [name, width, from] : kSubstepWidths)
        if (const SubstepWidth chosen = substepWidth(from); from <= particles && !(chosen == last))
            visit(last = chosen);
}

}  // namespace demolish
