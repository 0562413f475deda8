// SPDX-License-Identifier: Apache-2.0
// Thresholds that were measured once, in the user's cache folder: found again by body and setting.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/session/shot.h"
#include "sim_cuda/api/breakable_body.h"

namespace demolish {

struct CachedThreshold {
    double share = 0;                ///< v_th / v_c, mean over packings
    double lowest = 0, highest = 0;  ///< of single packings
    double critical_velocity = 0;    ///< m/s, at which it was measured
    uint32_t packings = 1;
    double tolerance = 0.05;  ///< of each packing's bracket
    double break_at = 0;      ///< m/s, for which the strength was sought and found; 0: it was not
};

/// $XDG_CACHE_HOME/demolish/thresholds, or ~/.cache/... Empty where the environment names neither.
std::filesystem::path thresholdCacheFolder();

/// Hash of everything that the share of `body` hangs on: its particles and bonds, material, stiffness, the
/// impact without its velocity. Not of v_c, which a threshold is nearly proportional to, nor of the device.
uint64_t thresholdKey(const Shot& shot, const BreakableBody& body);

/// Measurements of one body and setting at several strengths, the weakest first.
using CachedThresholds = std::vector<CachedThreshold>;

/// None where there is no file, or one that is damaged or of another version.
CachedThresholds readCachedThresholds(const std::filesystem::path& folder, uint64_t key);
/// Beside those at other strengths, in place of one at the same; of those found for one velocity to break at
/// the last is that velocity's. Whole or not at all; a place that cannot be written is warned of.
void writeCachedThreshold(const std::filesystem::path& folder, uint64_t key,
                          const CachedThreshold& threshold);
/// The same without a file.
void keep(const CachedThreshold& threshold, CachedThresholds& among);
/// The one measured at this critical velocity (m/s) within 1 %, or null.
const CachedThreshold* measuredAt(const CachedThresholds& measured, double critical_velocity);

/// The one whose strength was found for this velocity to break at (m/s) within 0.5 %, or null.
const CachedThreshold* foundFor(const CachedThresholds& measured, double break_at);

/// v_th / v_c at this critical velocity, by the power law through the two measured ones next to it; by the
/// share alone where there is one. A threshold is proportional to the strength only nearly: how a foot's edge
/// tips over hangs on the speed beside the waves'. `measured` is not empty.
double shareAt(const CachedThresholds& measured, double critical_velocity);
/// The critical velocity (m/s) at which the threshold is `velocity`, by shareAt().
double criticalVelocityAt(const CachedThresholds& measured, double velocity);

}  // namespace demolish
