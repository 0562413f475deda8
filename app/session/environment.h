// SPDX-License-Identifier: Apache-2.0
// What lights a shot, as it is chosen: by name, by file, by hour.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/lighting.h"
#include "engine/surroundings/own_surroundings.h"

namespace demolish {

struct Environment {
    engine::SurroundingsKind kind = engine::SurroundingsKind::kSky;
    std::filesystem::path file;  ///< of kFile
    double turn = 0;             ///< degrees about the vertical, of a file's picture
    /// Set: where the sun of a clear sky stands at this hour of a day in spring, 45 degrees north; at noon it
    /// comes from the scene's own side. Left out: the scene's sun.
    std::optional<double> hour;
    std::optional<glm::vec3> sun_colour;  ///< in place of the surroundings' own

    bool operator==(const Environment&) const = default;
};

/// By its ending.
bool isEnvironmentFile(const std::filesystem::path& file);
/// "sky", "studio", "overcast", or a file that ends in .hdr or .exr. Throws UsageError for what is none of
/// these.
void setEnvironment(Environment& environment, const std::string& name);
/// The same word back; of a file its name without folder.
std::string environmentName(const Environment& environment);

const std::vector<std::string>& ownEnvironmentNames();
const std::vector<std::string>& floorNames();  ///< in the order of engine::FloorMaterial
const std::vector<std::string>& toneNames();   ///< in the order of engine::ToneCurve

/// Unit, towards the sun at that hour for a scene whose light travels along `sun_direction`.
glm::vec3 sunAtHour(double hour, glm::vec3 sun_direction);

/// What the renderer is given: the chosen surroundings, made once and kept, and their sun in `lighting`.
/// Throws InputFileError.
engine::Lighting litBy(const Environment& environment, engine::Lighting lighting);

}  // namespace demolish
