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

/// The list anchor = [...] of a scene file, whose bodies and height are known: the file gives metres, Shot
/// heights.
std::vector<Anchor> readAnchors(TomlReader& reader, const Shot& shot);
/// The same of a body (`at`: "body[0]."), whose model and size are known.
std::vector<Anchor> readAnchors(TomlReader& reader, const std::string& at, const Shot& shot,
                                const SceneBody& body);
/// The list `at` + path = [...] and path_motion; without keys where there is none. `height` of the shot, m.
MotionPath readPath(TomlReader& reader, const std::string& at, double height);

/// All that is held, m: the scene's own anchors, then those of the bodies as they stand.
std::vector<Anchor> anchorsOf(const Shot& shot, const std::vector<BodyInstance>& bodies);

}  // namespace demolish
