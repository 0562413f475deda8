// SPDX-License-Identifier: Apache-2.0
// What a PassClock tells.
#pragma once

namespace demolish::engine::gl {

/// GPU time of one pass. Passes of one frame follow each other without gaps.
struct PassTime {
    const char* name;  ///< a literal
    double ms;
};

}  // namespace demolish::engine::gl
