// SPDX-License-Identifier: Apache-2.0
// What two runs of one shot must have in common, and what each must keep.
#pragma once
#include <string>
#include <vector>

#include "tests/fuzz/shots/shot_run.h"

namespace demolish::fuzz {

struct Finding {
    std::string kind;  ///< "crash", "hang", "body", "frame", "refusal", "status", "hash", "books", "coarse"
    std::string sentence;  ///< what was seen
};

/// All kinds but "coarse": open books of what moves too far in a substep for a hit to be resolved.
bool fails(const Finding& finding);

std::vector<Finding> findingsOf(const ShotRun& alone, const ShotRun& watched);

}  // namespace demolish::fuzz
