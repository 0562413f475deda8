// SPDX-License-Identifier: Apache-2.0
// What a shot will take, said before it is run: counted from its set-up, timed on this machine.
#pragma once
#include <cstdint>
#include <string>

#include "app/session/shot.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Counted; the same on every machine.
struct ShotWork {
    uint32_t bodies = 0, particles = 0, bonds = 0;  ///< of all bodies
    double time_step = 0;                           ///< s
    uint32_t substeps = 0;                          ///< of a frame
    uint64_t settle_substeps = 0;                   ///< before the first frame
    bool steps_bonds = true;  ///< false: preset pieces, rigid from start to end; substeps are nobody's work
};
ShotWork workOf(const Shot& shot, const SceneSetup& setup);

/// Wall time of a substep, s: a fixed part and one for each particle that is stepped with its bonds.
struct SubstepTime {
    double fixed = 0, each = 0;
    double of(double particles) const { return fixed + each * particles; }
};

/// How fast a device steps bodies that are whole, and bodies while they break.
struct DevicePace {
    SubstepTime whole, breaking;
};
/// Measured now, on two small blocks of stone, in some tenths of a second. `particles`: of the shot that it
/// is for. Throws DeviceError.
DevicePace measurePace(bool on_gpu, uint32_t particles);

/// Expected, while every body is awake and bonded; what sleeps or moves as rigid pieces takes less. Nothing
/// of shots that step no bonds: rigid pieces are not priced.
struct ShotCost {
    double settle_seconds = 0;
    double whole_frame_ms = 0, breaking_frame_ms = 0;
};
ShotCost costOf(const ShotWork& work, const DevicePace& pace);

/// False: even a slow machine makes it at a useful rate, or no bond is stepped; nothing has to be measured.
bool mayBeSlow(const ShotWork& work, bool on_gpu);
/// One sentence with what it takes and the knobs that change it; "" for a shot that is not slow: below 1 s a
/// frame and 10 s of settling.
std::string slowNote(const ShotWork& work, const ShotCost& cost);

/// "2.4 s", "13 ms" or "4.2 us".
std::string shownTime(double seconds);

}  // namespace demolish
