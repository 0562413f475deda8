// SPDX-License-Identifier: Apache-2.0
#include "app/session/paint_names.h"

#include <algorithm>

namespace demolish {

const std::vector<std::string>& paintChannelNames() {
    static const std::vector<std::string> names{"red", "green", "blue", "alpha"};
    return names;
}

std::optional<PaintChannel> paintChannelOf(const std::string& name) {
    const auto& names = paintChannelNames();
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) return std::nullopt;
    return static_cast<PaintChannel>(at - names.begin());
}

}  // namespace demolish
