// SPDX-License-Identifier: Apache-2.0
// The one way from JSON values to text. File names may hold any bytes, JSON only UTF-8.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace demolish {

/// What is no UTF-8 stands as U+FFFD. `indent`: spaces a level; -1: all on one line. No line end behind it.
std::string jsonText(const nlohmann::ordered_json& json, int indent);

}  // namespace demolish
