// SPDX-License-Identifier: Apache-2.0
// Surroundings take tenths of a second to make: those used last are kept.
#include "app/session/environment.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <deque>
#include <mutex>
#include <numbers>
#include <utility>

#include "engine/image/png.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr size_t kKept = 4;
const std::vector<std::string> kEnvironments = {"sky", "studio", "overcast"};

using Kept = std::pair<engine::SurroundingsChoice, std::shared_ptr<const engine::Surroundings>>;

std::shared_ptr<const engine::Surroundings> surroundingsFor(const engine::SurroundingsChoice& choice) {
    static std::mutex mutex;
    static std::deque<Kept> kept;
    const std::lock_guard lock(mutex);
    for (const auto& [known, surroundings] : kept)
        if (known == choice) return surroundings;
    try {
        kept.emplace_front(choice, engine::makeSurroundings(choice));
    } catch (const engine::ImageError& error) {
        throw InputFileError(error.what());
    }
    if (kept.size() > kKept) kept.pop_back();
    return kept.front().second;
}

}  // namespace

bool isEnvironmentFile(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".hdr" || ending == ".exr";
}

void setEnvironment(Environment& environment, const std::string& name) {
    const auto own = std::find(kEnvironments.begin(), kEnvironments.end(), name);
    if (own != kEnvironments.end()) {
        environment.kind = static_cast<engine::SurroundingsKind>(own - kEnvironments.begin());
        return;
    }
    const std::filesystem::path file(name);
    if (!isEnvironmentFile(file))
        throw UsageError("there are no surroundings '" + name +
                         "'; choose sky, studio, overcast, or a file that ends in .hdr or .exr");
    environment.kind = engine::SurroundingsKind::kFile;
    environment.file = file;
}

std::string environmentName(const Environment& environment) {
    if (environment.kind == engine::SurroundingsKind::kFile) return environment.file.filename().string();
    return kEnvironments[static_cast<size_t>(environment.kind)];
}

const std::vector<std::string>& ownEnvironmentNames() {
    return kEnvironments;
}

const std::vector<std::string>& floorNames() {
    static const std::vector<std::string> names = {"checker", "concrete", "planks", "grid",
                                                   "sweep",   "shadow",   "none"};
    return names;
}

const std::vector<std::string>& toneNames() {
    static const std::vector<std::string> names = {"film", "agx", "neutral", "none"};
    return names;
}

glm::vec3 sunAtHour(double hour, glm::vec3 sun_direction) {
    constexpr double kDegree = std::numbers::pi / 180, kLatitude = 45 * kDegree, kDeclination = 15 * kDegree;
    const double turn = (hour - 12) * 15 * kDegree;
    // Towards north, up and west, from the noon sun's side.
    const double up = std::sin(kLatitude) * std::sin(kDeclination) +
                      std::cos(kLatitude) * std::cos(kDeclination) * std::cos(turn);
    const double towards = std::sin(kLatitude) * std::cos(kDeclination) * std::cos(turn) -
                           std::cos(kLatitude) * std::sin(kDeclination);
    const double beside = std::cos(kDeclination) * std::sin(turn);
    glm::vec3 side(-sun_direction.x, 0, -sun_direction.z);
    side = glm::length(side) > 1e-4f ? glm::normalize(side) : glm::vec3(0, 0, 1);
    const glm::vec3 across = glm::cross(side, glm::vec3(0, 1, 0));
    return glm::normalize(static_cast<float>(towards) * side + static_cast<float>(beside) * across +
                          glm::vec3(0, static_cast<float>(up), 0));
}

engine::Lighting litBy(const Environment& environment, engine::Lighting lighting) {
    const float length = glm::length(lighting.sun_direction);
    engine::SurroundingsChoice choice;
    choice.kind = environment.kind;
    if (choice.kind == engine::SurroundingsKind::kFile) {
        choice.file = environment.file;
        choice.turn = environment.turn;
    } else {
        choice.to_sun = length > 1e-12f ? -lighting.sun_direction / length : glm::vec3(0, 1, 0);
        if (environment.hour) choice.to_sun = sunAtHour(*environment.hour, lighting.sun_direction);
    }
    lighting.surroundings = surroundingsFor(choice);
    const std::optional<engine::Sun>& sun = lighting.surroundings->sun;
    if (sun) {
        lighting.sun_direction = -sun->towards;
        lighting.sun_tangent = sun->tangent;
    }
    lighting.sun_colour = sun ? sun->colour : glm::vec3(0);
    if (environment.sun_colour) lighting.sun_colour = *environment.sun_colour;
    return lighting;
}

}  // namespace demolish
