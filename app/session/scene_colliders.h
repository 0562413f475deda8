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

/// Where the bodies stand, for what has no end.
struct SceneSight {
    Double3 centre;     ///< m
    double radius = 1;  ///< m
};

/// All but the floor, which has a pass of its own. Of a plane as much as lies round the bodies.
std::vector<engine::ColliderDraw> drawnColliders(const Shot& shot, const SceneSight& sight);

}  // namespace demolish
