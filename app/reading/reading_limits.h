// SPDX-License-Identifier: Apache-2.0
// What reading one model file may cost; the reader sets them on itself, its parent tells of them.
#pragma once
#include <chrono>
#include <cstdint>

namespace demolish {

inline constexpr std::chrono::seconds kMostReadingTime{60};  ///< of a processor
inline constexpr std::chrono::seconds kMostWaitingTime{
    180};                                ///< of a clock, for what hangs and computes nothing
inline constexpr int kOutOfMemory = 90;  ///< exit code of a reader that had too little

/// Eight, or half of the machine's where that is less.
uint64_t mostReadingGibibytes();

/// Memory (not where a sanitizer needs terabytes of addresses), processor time, no files, no core dump; and
/// it ends with its parent.
void limitThisReader();

}  // namespace demolish
