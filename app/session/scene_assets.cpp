// SPDX-License-Identifier: Apache-2.0
#include "app/session/scene_assets.h"

#include "app/session/asset_files.h"
#include "app/session/material_file.h"
#include "app/session/model_shot.h"
#include "sim_cuda/api/errors.h"

namespace demolish {

OwnMaterial loadMaterial(const std::string& name, const std::filesystem::path& file) {
    TomlReader reader(file);
    requireVersion(reader);
    OwnMaterial own{name, {}, {}};
    own.material.name = file.stem().string();
    std::string title;
    reader.read("name", own.material.name);
    reader.read("title", title);
    readMaterial(reader, "", own.material);
    readLook(reader, "look.", own.look);
    reader.requireAllRead();
    return own;
}

OwnMaterial readOwnMaterial(TomlReader& reader, const std::string& key) {
    std::string preset;
    reader.read(key, preset);
    try {
        const std::filesystem::path file = tomlFileOf(kMaterials, preset, reader.file().parent_path());
        const bool ships = std::filesystem::path(preset).extension() != ".toml";
        return loadMaterial(ships ? preset : file.string(), file);
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

namespace {

void readUnit(TomlReader& reader, const std::string& key, const std::filesystem::path& model, double& unit) {
    if (!reader.has(key)) return;
    std::string name;
    reader.read(key, name);
    const auto known = lengthUnitOf(name);
    if (!known) reader.fail(key, "must be one of " + listed(lengthUnitNames()));
    if (model.empty()) reader.fail(key, "is that of a model, and there is none here");
    if (const std::string refusal = refusalOfUnit(model); !refusal.empty())
        reader.fail(key, "must be left out: " + refusal);
    unit = *known;
}

}  // namespace

void readPart(TomlReader& reader, const std::string& prefix, const std::filesystem::path& model,
              ModelPart& part) {
    reader.read(prefix + "node", part.node);
    std::string up = part.up == UpAxis::kY ? "y" : "z";
    reader.read(prefix + "up", up);
    if (up != "y" && up != "z") reader.fail(prefix + "up", "must be \"y\" or \"z\"");
    part.up = up == "y" ? UpAxis::kY : UpAxis::kZ;
    readUnit(reader, prefix + "unit", model, part.unit);
}

}  // namespace demolish
