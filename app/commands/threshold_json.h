// SPDX-License-Identifier: Apache-2.0
// A shot's threshold in reports.
#pragma once
#include <nlohmann/json.hpp>

#include "app/session/threshold.h"

namespace demolish {

/// {break_at, predicted, scatter, measured or null, source}, m/s; null where nothing hits the body.
inline nlohmann::ordered_json thresholdJson(const Shot& shot, const BreakableBody& body) {
    const auto threshold = thresholdOf(shot, body);
    if (!threshold) return nullptr;
    nlohmann::ordered_json json{{"predicted", threshold->predicted},
                                {"scatter", threshold->scatter},
                                {"measured", nullptr},
                                {"source", threshold->source()},
                                {"break_at", nullptr}};
    if (threshold->measured) json["measured"] = *threshold->measured;
    if (shot.break_at) json["break_at"] = *shot.break_at;
    return json;
}

}  // namespace demolish
