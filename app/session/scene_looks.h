// SPDX-License-Identifier: Apache-2.0
// Looks of a scene's models, in the renderer's words.
#pragma once
#include <optional>

#include "engine/looks/body_looks.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// Triangles numbered through the scene as its exterior vertices have them; nothing where no model has looks.
/// The pictures' texels stay the bodies'.
std::optional<engine::BodyLooks> sceneLooks(const SceneSetup& setup);

}  // namespace demolish
