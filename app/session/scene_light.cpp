// SPDX-License-Identifier: Apache-2.0
// What the picture of a scene is made of.
#include "app/session/scene_light.h"

#include <algorithm>

#include "app/session/material_file.h"
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/model_set.h"

namespace demolish {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kLeastLength = 1e-3;   ///< of a direction; m between eye and target
constexpr Range kColourRange{0, 1000};  // linear; the sun's is above 1
constexpr Range kTimeRange{0, 3600};    // s
constexpr Range kAngleRange{5, 120};    // degrees

/// What the table that `at` names says about where a camera is, where and how wide it looks; `look`: a Camera
/// or one of its keys.
template <class Look>
void readLooking(TomlReader& reader, const std::string& at, Look& look) {
    reader.readVector(at + "eye_m", look.eye, kPlaceRange);
    reader.readVector(at + "target_m", look.target, kPlaceRange);
    reader.readVector(at + "up", look.up, kDirectionRange);
    if (glm::distance(look.eye, look.target) < kLeastLength)
        reader.fail(at + "eye_m", "must be apart from " + at + "target_m, or it looks nowhere");
    if (reader.has(at + "field_of_view_deg")) {
        double degrees = 0;
        reader.read(at + "field_of_view_deg", degrees, kAngleRange);
        look.field_of_view = static_cast<float>(degrees * kDegree);
    }
    if (!reader.has(at + "up")) return;
    const glm::vec3 across = glm::cross(glm::normalize(look.target - look.eye), look.up);
    if (!(glm::length(across) > kLeastLength * glm::length(look.up)))
        reader.fail(at + "up", "must have a length, and not lie along the way from eye to target");
}

/// What a key leaves out is as before.
std::vector<CameraKey> readCameraPath(TomlReader& reader, const engine::Camera& start) {
    std::vector<CameraKey> path(reader.count("camera.path", kMostCameraKeys));
    CameraKey before = startKey(start);
    for (size_t k = 0; k < path.size(); ++k) {
        const std::string at = "camera.path[" + std::to_string(k) + "].";
        if (!reader.has(at + "at_s")) reader.fail(at + "at_s", "is missing");
        path[k] = before;
        reader.read(at + "at_s", path[k].time, kTimeRange);
        readLooking(reader, at, path[k]);
        if (!(path[k].time > before.time))
            reader.fail(at + "at_s", k == 0 ? "must be above 0: at 0 s the camera is at camera.eye_m"
                                            : "must be later than that of the key before it");
        before = path[k];
    }
    return path;
}

engine::Camera readCamera(TomlReader& reader) {
    engine::Camera camera;
    readLooking(reader, "camera.", camera);
    return camera;
}

void readFloat(TomlReader& reader, const std::string& path, float& value, const Range& range) {
    double number = value;
    reader.read(path, number, range);
    value = static_cast<float>(number);
}

/// The place of the word in the list.
size_t readWord(TomlReader& reader, const std::string& path, const std::vector<std::string>& words,
                size_t present) {
    std::string word = words[present];
    reader.read(path, word);
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) {
        std::string all;
        for (const std::string& w : words) all += (all.empty() ? "" : ", ") + w;
        reader.fail(path, "must be one of " + all);
    }
    return static_cast<size_t>(found - words.begin());
}

void readEnvironment(TomlReader& reader, const std::filesystem::path& folder, Environment& environment) {
    if (reader.has("light.environment")) {
        std::string name;
        reader.read("light.environment", name);
        try {
            setEnvironment(environment, name);
        } catch (const UsageError& error) {
            reader.fail("light.environment", std::string("is wrong: ") + error.what());
        }
        if (environment.kind == engine::SurroundingsKind::kFile) environment.file = folder / environment.file;
    }
    reader.read("light.environment_turn_deg", environment.turn, kTurnRange);
    if (reader.has("light.hour")) {
        environment.hour.emplace(12);
        reader.read("light.hour", *environment.hour, kHourRange);
    }
    if (reader.has("light.sun_colour")) {
        environment.sun_colour.emplace(0);
        reader.readVector("light.sun_colour", *environment.sun_colour, kColourRange);
    }
}

}  // namespace

void readPicture(TomlReader& reader, const std::filesystem::path& folder, Shot& shot) {
    if (reader.has("camera")) {
        shot.camera = readCamera(reader);
        shot.camera_path = readCameraPath(reader, *shot.camera);
    }
    engine::Lighting& light = shot.lighting;
    readEnvironment(reader, folder, shot.environment);
    reader.readVector("light.sun_direction", light.sun_direction, kDirectionRange);
    if (glm::length(light.sun_direction) < kLeastLength)
        reader.fail("light.sun_direction", "must have a length: it is the way that the light travels");
    reader.readVector("light.floor_colour", light.floor_colour, {0, 1});
    light.floor = static_cast<engine::FloorMaterial>(
        readWord(reader, "light.floor", floorNames(), static_cast<size_t>(light.floor)));
    readFloat(reader, "light.exposure", light.exposure, kExposureRange);
    readFloat(reader, "light.white_balance_k", light.temperature, kTemperatureRange);
    light.tone = static_cast<engine::ToneCurve>(
        readWord(reader, "light.tone", toneNames(), static_cast<size_t>(light.tone)));
    readLook(reader, "look.", shot.look);
}

}  // namespace demolish
