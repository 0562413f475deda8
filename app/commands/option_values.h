// SPDX-License-Identifier: Apache-2.0
// Values of options, held to their ranges. Both throw UsageError, which names the option.
#pragma once
#include <cmath>
#include <string>

#include "app/session/shot.h"
#include "sim_cuda/api/errors.h"

namespace demolish {

inline double inRange(const char* option, double value, const Range& range, const char* unit) {
    requireInRange(option, value, range, unit);
    return value;
}

inline double wholeNumber(const char* option, double value, const Range& range) {
    requireInRange(option, value, range, "");
    if (value != std::floor(value)) throw UsageError(std::string(option) + " must be a whole number");
    return value;
}

}  // namespace demolish
