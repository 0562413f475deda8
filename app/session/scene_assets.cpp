// SPDX-License-Identifier: Apache-2.0
#include "app/session/scene_assets.h"

#include <algorithm>
#include <iterator>

#include "app/session/asset_files.h"
#include "app/session/material_file.h"
#include "app/session/model_shot.h"
#include "sim_cuda/api/errors.h"

namespace demolish {

OwnMaterial loadMaterial(const std::string& name, const std::filesystem::path& file) {
    TomlReader reader(file);
    requireVersion(reader);
    OwnMaterial own{name, {}, {}, {}};
    own.material.name = file.stem().string();
    std::string title;
    reader.read("name", own.material.name);
    reader.read("title", title);
    readMaterial(reader, "", own.material);
    readLook(reader, "look.", own.look);
    reader.requireAllRead();
    return own;
}

void showInside(const OwnMaterial& inner, OwnMaterial& own) {
    for (const OwnMaterial* material : {static_cast<const OwnMaterial*>(&own), &inner})
        if (material->look.isTransparent())
            throw UsageError("an inner material goes with opaque materials, and " + material->name +
                             " is transparent");
    const engine::SurfaceLook& from = inner.look;
    engine::SurfaceLook& to = own.look;
    std::copy(std::begin(from.interior_colour), std::end(from.interior_colour), to.interior_colour);
    std::copy(std::begin(from.dust_colour), std::end(from.dust_colour), to.dust_colour);
    std::copy(std::begin(from.texture_colour), std::end(from.texture_colour), to.texture_colour);
    to.interior_roughness = from.interior_roughness;
    to.noise_strength = from.noise_strength;
    to.texture = from.texture;
    to.texture_size = from.texture_size;
    to.texture_outside = 0;
    own.inner = inner.name;
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

void readInside(TomlReader& reader, const std::string& key, OwnMaterial& own) {
    if (!reader.has(key)) return;
    const OwnMaterial inner = readOwnMaterial(reader, key);
    try {
        showInside(inner, own);
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
