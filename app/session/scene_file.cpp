// SPDX-License-Identifier: Apache-2.0
// Reading of scene and material files.
#include "app/session/scene_file.h"

#include <algorithm>

#include "app/session/asset_files.h"
#include "app/session/material_file.h"
#include "app/session/scene_colliders.h"
#include "app/session/scene_light.h"
#include "app/session/scene_parts_file.h"
#include "app/session/threshold_table.h"
#include "app/session/toml_reader.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kAngleRange{-100, 100};  // rad

void readStrengthRow(TomlReader& reader, std::string& row) {
    if (!reader.has("strength_row")) return;
    reader.read("strength_row", row);
    const auto rows = ThresholdTable::ofAssets().rows();
    if (std::find(rows.begin(), rows.end(), row) == rows.end())
        reader.fail("strength_row", "must be one of " + listed(rows));
}

void readRepair(TomlReader& reader, RepairOptions& repair) {
    std::string mode = repairModeName(repair.mode);
    reader.read("repair", mode);
    const auto known = repairModeOf(mode);
    if (!known) reader.fail("repair", "must be one of " + listed(repairModeNames()));
    repair.mode = *known;
    reader.read("thickness_m", repair.thickness, kThicknessRange);
}

/// The value of a key that is one of these names.
template <class Of>
void readName(TomlReader& reader, const std::string& key, const std::vector<std::string>& names,
              const Of& of) {
    if (!reader.has(key)) return;
    std::string name;
    reader.read(key, name);
    if (std::find(names.begin(), names.end(), name) == names.end())
        reader.fail(key, "must be one of " + listed(names));
    of(name);
}

void readMethod(TomlReader& reader, Shot& shot) {
    readName(reader, "method", methodNames(),
             [&](const std::string& name) { shot.method = *methodOf(name); });
    readName(reader, "pattern", patternNames(),
             [&](const std::string& name) { shot.pattern = patternOf(name); });
}

void readImpact(TomlReader& reader, Impact& impact) {
    std::string kind = "ball";
    reader.read("impact.kind", kind);
    if (kind == "ball")
        impact.kind = ImpactKind::kBall;
    else if (kind == "drop")
        impact.kind = ImpactKind::kDrop;
    else if (kind == "none")
        impact.kind = ImpactKind::kNone;
    else
        reader.fail("impact.kind", "must be \"ball\", \"drop\" or \"none\"");
    reader.read("impact.velocity_mps", impact.velocity, kVelocityRange);
    reader.read("impact.ball_radius_m", impact.ball_radius, {0, 100});
    reader.read("impact.direction", impact.direction, kDirectionRange);
    reader.read("impact.height_fraction", impact.height_fraction, {0, 1});
    reader.read("impact.arrival_s", impact.arrival_time, {0.01, 2});
    reader.read("impact.tilt_rad", impact.tilt, kAngleRange);
}

void readEffects(TomlReader& reader, EffectsSettings& effects) {
    std::string show = effects.on ? "on" : "off";
    reader.read("effects.show", show);
    if (show != "on" && show != "off") reader.fail("effects.show", "must be \"on\" or \"off\"");
    effects.on = show == "on";
    reader.read("effects.grit", effects.grit, kAmountRange);
    reader.read("effects.dust", effects.dust, kAmountRange);
    reader.read("effects.sparks", effects.sparks, kAmountRange);
    reader.read("effects.grains", effects.grains, kGrainRange);
    reader.read("effects.puffs", effects.puffs, kPuffRange);
}

void applyMaterialFile(Shot& shot, const std::string& name, const std::filesystem::path& file) {
    TomlReader reader(file);
    requireVersion(reader);
    Material material;
    material.name = file.stem().string();
    std::string title;
    reader.read("name", material.name);
    reader.read("title", title);
    readMaterial(reader, "", material);
    engine::SurfaceLook look;  // nothing of another material stays
    readLook(reader, "look.", look);
    reader.requireAllRead();
    shot.look = look;
    shot.material = material;
    shot.material_name = name;
}

/// A name that ships stays as it is, a path becomes one that holds wherever the program was started.
void readPreset(TomlReader& reader, const std::string& key, Shot& shot) {
    std::string preset = shot.material_name;
    reader.read(key, preset);
    try {
        const std::filesystem::path file = tomlFileOf(kMaterials, preset, reader.file().parent_path());
        const bool ships = std::filesystem::path(preset).extension() != ".toml";
        applyMaterialFile(shot, ships ? preset : file.string(), file);
    } catch (const UsageError& error) {
        reader.fail(key, std::string("is wrong: ") + error.what());
    }
}

std::filesystem::path readModelPath(TomlReader& reader, const std::string& key) {
    std::string model;
    reader.read(key, model);
    if (model.empty()) reader.fail(key, "is missing; name a mesh file relative to this one, or to assets");
    const std::filesystem::path file = modelFileOf(reader.file(), model);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        reader.fail(key,
                    "is '" + model + "', and there is no such file, neither beside this one nor in assets");
    return file;
}

}  // namespace

void applyMaterial(Shot& shot, const std::string& name) {
    applyMaterialFile(shot, name, tomlFileOf(kMaterials, name));
}

Shot loadSceneFile(const std::filesystem::path& file) {
    TomlReader reader(file);
    Shot shot;
    shot.scene = file.stem().string();
    shot.scene_file = file;
    requireVersion(reader);
    std::string title;
    reader.read("title", title);
    shot.model = readModelPath(reader, "model");
    if (reader.has("paper_model")) shot.paper_model = readModelPath(reader, "paper_model");
    readStrengthRow(reader, shot.strength_row);
    reader.read("height_m", shot.height, kHeightRange);
    readRepair(reader, shot.repair);
    readMethod(reader, shot);
    readPreset(reader, "material_preset", shot);
    readMaterial(reader, "material.", shot.material);
    if (reader.has("break_at_mps")) {
        shot.break_at.emplace();
        reader.read("break_at_mps", *shot.break_at, kBreakAtRange);
    }

    reader.read("particles.full", shot.fineness.full, {2, 4e6});
    reader.read("particles.draft", shot.fineness.draft, {2, 4e6});
    uint32_t seed = static_cast<uint32_t>(shot.seed);
    reader.read("particles.seed", seed, {0, 4294967295.0});
    shot.seed = seed;
    reader.read("solver.wave_speed_mps", shot.wave_speed, {0, 10000});
    reader.read("solver.settle_s", shot.settle_time, {0, 10});
    reader.read("solver.scene_radius_m", shot.scene_radius, {0.1, 1e4});
    reader.read("solver.fps", shot.fps, kFpsRange);
    reader.read("solver.time_scale", shot.time_scale, kTimeScaleRange);
    readImpact(reader, shot.impact);
    shot.bodies = readBodies(reader, shot.height);
    shot.balls = readBalls(reader, {std::max<size_t>(1, shot.bodies.size()), shot.height}, shot.impact);
    shot.phases = readPhases(reader);
    readEffects(reader, shot.effects);
    shot.colliders = readColliders(reader, shot.height);
    readPicture(reader, file.parent_path(), shot);
    reader.requireAllRead();
    return shot;
}

Shot loadScene(const std::string& name) {
    return loadSceneFile(tomlFileOf(kScenes, name));
}

}  // namespace demolish
