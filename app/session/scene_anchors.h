// SPDX-License-Identifier: Apache-2.0
// What holds the bodies of a scene, and the paths on which something moves: how a file names them, and what
// the solver is told.
#pragma once
#include <string>
#include <vector>

#include "app/session/shot.h"
#include "app/session/toml_reader.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// The list `at` + anchor = [...] of a scene file, of the whole scene (`at` is "") or of a body ("body[0].").
/// `height` of the bodies, m: the file gives metres, Shot heights. bodies: how many an anchor of the scene
/// may name.
std::vector<Anchor> readAnchors(TomlReader& reader, const std::string& at, double height, size_t bodies);
/// The list `at` + path = [...] and path_motion, likewise; without keys where there is none.
MotionPath readPath(TomlReader& reader, const std::string& at, double height);

/// All that is held, m: the scene's own anchors, then those of the bodies as they stand.
std::vector<Anchor> anchorsOf(const Shot& shot, const std::vector<BodyInstance>& bodies);

}  // namespace demolish
