// SPDX-License-Identifier: Apache-2.0
// Recipe files: the frame common to all, and bodies of blended shapes.
#include "assets/models/recipe.h"

#include "assets/models/recipe_values.h"

namespace demolish::sculptor {
namespace {

void readEnds(const toml::table& table, Part& part) {
    part.a = readPoint(table, "a");
    part.ra = readPositive(table, "ra");
    part.b = readPoint(table, "b");
    part.rb = readPositive(table, "rb");
}

Part readPart(const toml::table& table) {
    Part part;
    const auto kind = table["kind"].value_or(std::string());
    if (kind == "ellipsoid") {
        part.kind = PartKind::kEllipsoid;
        part.a = readPoint(table, "centre");
        part.radii = readPoint(table, "radii");
        if (!(part.radii.x > 0 && part.radii.y > 0 && part.radii.z > 0))
            refuse("radii", "must be greater than 0");
    } else if (kind == "cone") {
        part.kind = PartKind::kCone;
        readEnds(table, part);
    } else if (kind == "blade") {
        part.kind = PartKind::kBlade;
        readEnds(table, part);
        part.flat = readPositive(table, "flat");
    } else {
        refuse("kind", "of a part must be ellipsoid, cone or blade");
    }
    part.turn = {table["pitch"].value_or(0.0), table["yaw"].value_or(0.0), table["roll"].value_or(0.0)};
    part.blend = table["blend"].value_or(0.0);
    if (part.blend < 0) refuse("blend", "must not be negative");
    part.mirrored = table["mirrored"].value_or(false);
    part.carves = table["carves"].value_or(false);
    return part;
}

FieldRecipe readField(const toml::table& table) {
    FieldRecipe recipe;
    recipe.grid = readPositive(table, "grid");
    for (const toml::table* part : readTables(table, "part")) {
        try {
            recipe.parts.push_back(readPart(*part));
        } catch (const std::runtime_error& error) {
            throw std::runtime_error("part '" + (*part)["name"].value_or(std::string("?")) +
                                     "': " + error.what());
        }
    }
    if (recipe.parts.empty()) refuse("part", "must be a list of at least one table");
    if (recipe.parts.front().carves) refuse("part", "must not begin with one that carves");
    if (const toml::table* coat = table["coat"].as_table()) recipe.coat = readCoat(*coat);
    for (const toml::table* box : readTables(table, "detail"))
        recipe.details.push_back(
            {readPoint(*box, "low"), readPoint(*box, "high"), readPositive(*box, "factor")});
    return recipe;
}

}  // namespace

Recipe readRecipe(const std::filesystem::path& file) {
    try {
        const toml::table table = toml::parse_file(file.string());
        Recipe recipe;
        recipe.unit_m = readPositive(table, "unit_m");
        recipe.crease_degrees = readNumber(table, "crease_degrees");
        const auto kind = table["kind"].value_or(std::string());
        if (kind == "field")
            recipe.body = readField(table);
        else if (kind == "vessel")
            recipe.body = readVessel(table);
        else if (kind == "column")
            recipe.body = readColumn(table);
        else
            refuse("kind", "must be field, vessel or column");
        return recipe;
    } catch (const std::exception& error) {
        throw std::runtime_error(file.string() + ": " + error.what());
    }
}

}  // namespace demolish::sculptor
