// SPDX-License-Identifier: Apache-2.0
// What a scene's bodies fall on beside its floor: how a file names it, how large it is, how it is drawn.
#pragma once
#include <vector>

#include "app/session/shot.h"
#include "app/session/toml_reader.h"
#include "engine/scene/collider_draw.h"

namespace demolish {

/// The list collider = [...] of a scene file. `height` of the bodies, m: the file gives metres, Shot heights.
std::vector<Collider> readColliders(TomlReader& reader, double height);

/// The floor y = 0, which every scene has, and then the shot's own; m.
std::vector<Collider> collidersOf(const Shot& shot);

/// Those that are seen: the floor has a pass of its own, and other planes are walls that nobody sees.
std::vector<engine::ColliderDraw> drawnColliders(const Shot& shot);

}  // namespace demolish
