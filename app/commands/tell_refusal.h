// SPDX-License-Identifier: Apache-2.0
// Told once in a run, since pictures come all the same.
#pragma once
#include <spdlog/spdlog.h>

#include <string>

#include "engine/render/renderer.h"

namespace demolish {

inline void tellRefusal(const engine::Renderer& renderer) {
    static bool told = false;
    if (told || renderer.refusal().empty()) return;
    told = true;
    const std::string& reason = renderer.refusal();
    spdlog::warn(
        "the driver refuses a shader, so that pictures are drawn and not computed, which is slower: {}",
        reason.substr(0, reason.find('\n')));
}

}  // namespace demolish
