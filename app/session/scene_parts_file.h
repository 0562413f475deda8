// SPDX-License-Identifier: Apache-2.0
// The lists of a scene file: body = [...], ball = [...], phase = [...]; in-line tables or [[body]] alike.
#pragma once
#include <vector>

#include "app/session/shot.h"
#include "app/session/toml_reader.h"

namespace demolish {

/// Bodies of a scene, which may have models and materials of their own. `shot` holds what the file says of
/// all bodies. Empty when the file lists none.
std::vector<SceneBody> readBodies(TomlReader& reader, const Shot& shot);
/// Balls in order of time. Sets impact.velocity to the fastest ball's unless the file names a velocity of the
/// impact.
struct BodiesOfFile {
    size_t count = 1;   ///< at least 1
    double height = 1;  ///< m
};
std::vector<TimedBall> readBalls(TomlReader& reader, const BodiesOfFile& bodies, Impact& impact);
/// Phases in order of time.
std::vector<Phase> readPhases(TomlReader& reader);

}  // namespace demolish
