// SPDX-License-Identifier: Apache-2.0
// What a running session says of itself, for the scripts that drive the window.
#pragma once
#include <string>

#include "app/session/session.h"

namespace demolish {

std::string sessionJson(const Session& session);

}  // namespace demolish
