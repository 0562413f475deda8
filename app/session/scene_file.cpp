// SPDX-License-Identifier: Apache-2.0
// Reading of scene and material files.
#include "app/session/scene_file.h"

#include <algorithm>

#include "app/session/asset_files.h"
#include "app/session/material_file.h"
#include "app/session/model_shot.h"
#include "app/session/paint_names.h"
#include "app/session/scene_anchors.h"
#include "app/session/scene_assets.h"
#include "app/session/scene_colliders.h"
#include "app/session/scene_light.h"
#include "app/session/scene_parts_file.h"
#include "app/session/shot_bodies.h"
#include "app/session/threshold_table.h"
#include "app/session/toml_reader.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kAngleRange{-100, 100};  // rad
constexpr Range kThresholdTimes{0.1, 20};

void readStrengthRow(TomlReader& reader, std::string& row) {
    if (!reader.has("strength_row")) return;
    reader.read("strength_row", row);
    const auto rows = ThresholdTable::ofAssets().rows();
    if (std::find(rows.begin(), rows.end(), row) == rows.end())
        reader.fail("strength_row", "must be one of " + listed(rows));
}

void readSize(TomlReader& reader, Shot& shot) {
    const bool has_height = reader.has("height_m");
    if (has_height && reader.has("unit"))
        reader.fail("height_m", "and unit exclude each other: one scales the model, the other keeps it");
    reader.read("height_m", shot.height, kHeightRange);
    shot.keeps_size = !has_height && hasKnownSize(shot.model, shot.part);
    if (!reader.has("scale")) return;
    if (has_height) reader.fail("scale", "and height_m exclude each other: one is of sizes that files say");
    reader.read("scale", shot.height, kSetScaleRange);
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

void readPainted(TomlReader& reader, std::optional<PaintedStrength>& painted) {
    readName(reader, "particles.painted", paintChannelNames(),
             [&](const std::string& name) { painted = PaintedStrength{*paintChannelOf(name)}; });
    if (painted) reader.read("particles.painted_least", painted->least, kPaintedLeastRange);
}

void readMethod(TomlReader& reader, Shot& shot) {
    readName(reader, "looks", {"file", "material"}, [&](const std::string& name) {
        shot.looks = name == "file" ? LooksOf::kFile : LooksOf::kMaterial;
    });
    readName(reader, "method", methodNames(),
             [&](const std::string& name) { shot.method = *methodOf(name); });
    readName(reader, "pattern", patternNames(),
             [&](const std::string& name) { shot.pattern = patternOf(name); });
    if (!reader.has("pattern_axis")) return;
    reader.read("pattern_axis", shot.pattern_axis.emplace(), kDirectionRange);
    if (*shot.pattern_axis == Double3{}) reader.fail("pattern_axis", "is 0, 0, 0, which points nowhere");
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
    if (reader.has("impact.times_threshold")) {
        if (reader.has("impact.velocity_mps"))
            reader.fail("impact.times_threshold",
                        "and velocity_mps exclude each other: one follows from the other");
        reader.read("impact.times_threshold", impact.times_threshold.emplace(), kThresholdTimes);
    }
    reader.read("impact.ball_radius_m", impact.ball_radius, {0, 100});
    reader.read("impact.direction", impact.direction, kDirectionRange);
    if (reader.has("impact.height_fraction"))
        reader.read("impact.height_fraction", impact.height_fraction.emplace(), {0, 1});
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

void readMortar(TomlReader& reader, Shot& shot) {
    if (!reader.has("mortar")) return;
    Mortar mortar;
    if (!reader.has("mortar.tensile_strength_pa")) reader.fail("mortar.tensile_strength_pa", "is missing");
    reader.read("mortar.tensile_strength_pa", mortar.tensile_strength, {1, 1e11});
    reader.read("mortar.joint_m", mortar.joint, {0, 0.1});
    mortar.joint /= shot.height;
    shot.mortar = mortar;
}

/// Nothing of another material stays.
void putIn(const OwnMaterial& own, Shot& shot) {
    shot.look = own.look;
    shot.material = own.material;
    shot.material_name = own.name;
    shot.inner_material = own.inner;
}

void readPreset(TomlReader& reader, const std::string& key, Shot& shot) {
    OwnMaterial own = reader.has(key) ? readOwnMaterial(reader, key) : presetMaterial(shot.material_name);
    readInside(reader, "inner_material", own);
    putIn(own, shot);
}

/// What the scene says of all bodies is what the body that the fastest ball hits is like; the others keep
/// theirs.
void takeFromSubject(Shot& shot) {
    if (shot.bodies.empty()) return;
    const SceneBody subject = shot.bodies[subjectOf(shot)];
    if (subject.model || subject.part) {
        const Shot of = asOf(shot, subject);
        for (SceneBody& body : shot.bodies) {
            body.part = partOf(shot, body);
            if (!body.model) body.model = shot.model;
            if (*body.model != of.model || *body.part != of.part) continue;
            body.model.reset();
            body.part.reset();
        }
        shot.model = of.model;
        shot.part = of.part;
        shot.paper_model.reset();
        shot.strength_row.clear();
    }
    if (!subject.material) return;
    const OwnMaterial former{shot.material_name, shot.material, shot.look, shot.inner_material};
    for (SceneBody& body : shot.bodies) {
        if (!body.material)
            body.material = former;
        else if (body.material == subject.material)
            body.material.reset();
    }
    putIn(*subject.material, shot);
}

Shot loadScene(TomlReader& reader) {
    const std::filesystem::path& file = reader.file();
    Shot shot;
    shot.scene = file.stem().string();
    shot.scene_file = file;
    requireVersion(reader);
    std::string title;
    reader.read("title", title);
    if (reader.has("model") || reader.count("body", 1e9) == 0) shot.model = readModelPath(reader, "model");
    readPart(reader, "", shot.model, shot.part);
    if (reader.has("paper_model")) shot.paper_model = readModelPath(reader, "paper_model");
    readStrengthRow(reader, shot.strength_row);
    readSize(reader, shot);
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
    reader.read("particles.conform", shot.conform);
    reader.read("particles.refine", shot.refine, kRefineRange);
    readPainted(reader, shot.painted);
    reader.read("solver.wave_speed_mps", shot.wave_speed, {0, 10000});
    reader.read("solver.settle_s", shot.settle_time, {0, 10});
    reader.read("solver.scene_radius_m", shot.scene_radius, {0.1, 1e4});
    reader.read("solver.fps", shot.fps, kFpsRange);
    reader.read("solver.time_scale", shot.time_scale, kTimeScaleRange);
    readImpact(reader, shot.impact);
    shot.bodies = readBodies(reader, shot);
    reader.read("impact.body", shot.impact.body,
                {0, static_cast<double>(std::max<size_t>(1, shot.bodies.size()) - 1)});
    shot.balls = readBalls(reader, {std::max<size_t>(1, shot.bodies.size()), shot.height}, shot.impact);
    shot.phases = readPhases(reader);
    readEffects(reader, shot.effects);
    shot.colliders = readColliders(reader, shot.height);
    readMortar(reader, shot);
    shot.anchors = readAnchors(reader, shot);
    readPicture(reader, file.parent_path(), shot);
    reader.requireAllRead();
    takeFromSubject(shot);
    return shot;
}

}  // namespace

OwnMaterial presetMaterial(const std::string& name) {
    return loadMaterial(name, tomlFileOf(kMaterials, name));
}

void applyMaterials(Shot& shot, const std::string& name, const std::string& inner) {
    OwnMaterial own = presetMaterial(name);
    if (!inner.empty()) showInside(presetMaterial(inner), own);
    putIn(own, shot);
}

void applyMaterial(Shot& shot, const std::string& name) {
    applyMaterials(shot, name, shot.inner_material);
}

Shot loadSceneFile(const std::filesystem::path& file) {
    TomlReader reader(file);
    return loadScene(reader);
}

Shot loadSceneText(const std::string& text, const std::filesystem::path& place) {
    TomlReader reader(place, text);
    return loadScene(reader);
}

Shot loadScene(const std::string& name) {
    return loadSceneFile(tomlFileOf(kScenes, name));
}

}  // namespace demolish
