// SPDX-License-Identifier: Apache-2.0
// What stands in a set, as text between two processes of this program.
#pragma once
#include <string>

#include "sim_cuda/api/model_set.h"

namespace demolish {

inline constexpr size_t kMostThings = 4096;  ///< of a set; those beyond are not told

std::string setText(const ModelSet& set);
/// Throws BrokenStream: other text, numbers that are not finite, too many things.
ModelSet setOfText(const std::string& text);

}  // namespace demolish
