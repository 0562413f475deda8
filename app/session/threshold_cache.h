// Thresholds that were measured once, in the user's cache folder: found again by body and setting.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/session/shot.h"
#include "sim_cuda/api/breakable_body.h"

namespace demolish {

struct CachedThreshold {
    double share = 0;                ///< v_th / v_c, mean over packings
    double lowest = 0, highest = 0;  ///< of single packings
    double critical_velocity = 0;    ///< m/s, at which it was measured
    uint32_t packings = 1;
    double tolerance = 0.05;  ///< of each packing's bracket
};

/// $XDG_CACHE_HOME/demolish/thresholds, or ~/.cache/... Empty where the environment names neither.
std::filesystem::path thresholdCacheFolder();

/// Hash of everything that the share of `body` hangs on: its particles and bonds, material, stiffness, the
/// impact without its velocity. Not of v_c, which a threshold is proportional to, nor of the device.
uint64_t thresholdKey(const Shot& shot, const BreakableBody& body);

/// None where there is no file, or one that is damaged or of another version.
std::optional<CachedThreshold> readCachedThreshold(const std::filesystem::path& folder, uint64_t key);
/// Whole or not at all. Throws OutputError.
void writeCachedThreshold(const std::filesystem::path& folder, uint64_t key,
                          const CachedThreshold& threshold);

}  // namespace demolish
