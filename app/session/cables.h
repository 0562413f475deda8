// SPDX-License-Identifier: Apache-2.0
// Ropes and rods on which led bodies hang: nothing feels them.
#pragma once
#include <vector>

#include "app/session/shot.h"
#include "engine/scene/collider_draw.h"

namespace demolish {

/// Those of all bodies in sight that have one, as they are after `time` s, in m.
std::vector<engine::ColliderDraw> drawnCables(const Shot& shot, double time);

}  // namespace demolish
