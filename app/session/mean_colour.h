// SPDX-License-Identifier: Apache-2.0
// The one colour that comes nearest to what a model file says, for things that are drawn in one.
#pragma once
#include <optional>

#include "sim_cuda/api/model_file.h"

namespace demolish {

/// Linear, 0 to 1: by area, of pictures the mean of all their texels. None where the file says no colour.
std::optional<Float3> meanColour(const ImportedModel& model);

}  // namespace demolish
