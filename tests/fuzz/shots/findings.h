// SPDX-License-Identifier: Apache-2.0
// What two runs of one shot must have in common, and what each must keep.
#pragma once
#include <string>
#include <vector>

#include "tests/fuzz/shots/shot_run.h"

namespace demolish::fuzz {

struct Finding {
    std::string kind;      ///< "crash", "hang", "body", "frame", "refusal", "status", "hash", "books"
    std::string sentence;  ///< what was seen
};

/// None is good.
std::vector<Finding> findingsOf(const ShotRun& alone, const ShotRun& watched);

}  // namespace demolish::fuzz
