// SPDX-License-Identifier: Apache-2.0
// Pieces of a megabyte, each by one thread.
#include "app/session/recorded_array.h"

#include <sys/mman.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace demolish {
namespace {

/// Beyond these hardly anything gets faster, and the solver needs some too.
constexpr size_t kThreads = 8;
constexpr size_t kPiece = size_t{1} << 20;

/// A hint that may be refused.
void adviseLargePages(void* memory, size_t bytes) {
    constexpr size_t kLargePage = size_t{2} << 20;
    const size_t into_page = reinterpret_cast<uintptr_t>(memory) % kLargePage;
    const size_t before = into_page > 0 ? kLargePage - into_page : 0;
    if (bytes >= before + kLargePage)
        madvise(static_cast<std::byte*>(memory) + before, (bytes - before) / kLargePage * kLargePage,
                MADV_HUGEPAGE);
}

}  // namespace

void copyIntoNewMemory(void* to, const void* from, size_t bytes) {
    if (bytes == 0) return;
    adviseLargePages(to, bytes);
    auto* target = static_cast<std::byte*>(to);
    const auto* source = static_cast<const std::byte*>(from);
    const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    tbb::task_arena(static_cast<int>(std::min(kThreads, allowed))).execute([&] {
        tbb::parallel_for(size_t{0}, (bytes + kPiece - 1) / kPiece, [&](size_t piece) {
            const size_t first = piece * kPiece;
            std::memcpy(target + first, source + first, std::min(kPiece, bytes - first));
        });
    });
}

}  // namespace demolish
