// SPDX-License-Identifier: Apache-2.0
// What a person can ask of a running session.
#pragma once
#include <variant>

#include "app/session/shot.h"

namespace demolish::command {

struct Play {};
struct Pause {};
struct TogglePlay {};
struct Step {};   ///< one frame, then pause
struct Reset {};  ///< back to frame 0, with the impact as it is chosen now
struct Fire {};   ///< the shot's ball, now
struct ShootAt {  ///< a ball from `from` through `target`, m
    Double3 from, target;
};
struct ChangeShot {  ///< live values act at once, the others rebuild after a rest
    Shot shot;
};
struct CancelRebuild {};
struct MeasureEnergy {  ///< after every simulated frame, or no more
    bool on = false;
};
struct Scrub {  ///< shows a recorded frame, or SessionStatus::newest, and pauses
    size_t frame = 0;
};

using Any = std::variant<Play, Pause, TogglePlay, Step, Reset, Fire, ShootAt, ChangeShot, CancelRebuild,
                         MeasureEnergy, Scrub>;

}  // namespace demolish::command
