// SPDX-License-Identifier: Apache-2.0
// Channels of painted strength by name, as on the command line.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim_cuda/api/paint.h"

namespace demolish {

/// In the order of the enumerators.
const std::vector<std::string>& paintChannelNames();
std::optional<PaintChannel> paintChannelOf(const std::string& name);

}  // namespace demolish
