// SPDX-License-Identifier: Apache-2.0
// What reading one model file may cost; the reader sets them on itself, its parent tells of them.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>

namespace demolish {

inline constexpr int kOutOfMemory = 90;  ///< exit code of a reader that had too little

struct ReadingTime {
    std::chrono::seconds computing;  ///< of a processor
    std::chrono::seconds waiting;    ///< of a clock, for what hangs and computes nothing
};
/// 20 s and a second more for each MiB, many times what a sound file needs; five times that by the clock,
/// since others may use the processor as well.
ReadingTime mostReadingTime(const std::filesystem::path& file);

/// Eight, or half of the machine's where that is less.
uint64_t mostReadingGibibytes();

/// Memory (not where a sanitizer needs terabytes of addresses), processor time, no files, no core dump; and
/// it ends with its parent.
void limitThisReader(std::chrono::seconds computing);

}  // namespace demolish
