// SPDX-License-Identifier: Apache-2.0
// Surroundings that need no file, lit from where the scene has its sun.
#pragma once
#include <filesystem>
#include <memory>

#include "engine/surroundings/surroundings.h"

namespace demolish::engine {

enum class SurroundingsKind { kSky, kStudio, kOvercast, kFile };

struct SurroundingsChoice {
    SurroundingsKind kind = SurroundingsKind::kSky;
    std::filesystem::path file{};  ///< of kFile
    double turn = 0;               ///< degrees about the vertical, of a file's picture
    glm::vec3 to_sun{0, 1, 0};     ///< unit; of all but kFile, whose picture has its own
    bool operator==(const SurroundingsChoice&) const = default;
};

/// kSky: clear air, the sun where it is wanted. kStudio: a dim room with a large lamp there, one that fills
/// from the other side, a strip of light behind. kOvercast: clouds, brightest overhead, with a shadow as wide
/// as it is weak. kFile: the picture, its sun taken out of it. Throws ImageError.
std::shared_ptr<const Surroundings> makeSurroundings(const SurroundingsChoice& choice);

/// Of a scene that says nothing of them: a clear sky, made once.
const std::shared_ptr<const Surroundings>& usualSurroundings();

}  // namespace demolish::engine
