// SPDX-License-Identifier: Apache-2.0
// Recipe files of turned bodies.
#include <algorithm>

#include "assets/models/recipe_values.h"

namespace demolish::sculptor {
namespace {

RingShape readShape(const std::string& name) {
    if (name == "round") return RingShape::kRound;
    if (name == "square") return RingShape::kSquare;
    if (name == "fluted") return RingShape::kFluted;
    refuse("ring", "must be [radius, y, \"round\", \"square\" or \"fluted\"]");
}

}  // namespace

VesselRecipe readVessel(const toml::table& table) {
    VesselRecipe recipe;
    recipe.height = readPositive(table, "height");
    recipe.wall = readPositive(table, "wall");
    recipe.rim_rise = readPositive(table, "rim_rise");
    recipe.inner_bottom = readPositive(table, "inner_bottom");
    recipe.fractions = readNumbers(table, "profile_fractions");
    recipe.radii = readNumbers(table, "profile_radii");
    recipe.outer_rings = readNumbers(table, "outer_rings");
    recipe.inner_rings = readNumbers(table, "inner_rings");
    recipe.sectors = readSectors(table);
    if (recipe.fractions.size() != recipe.radii.size() || recipe.radii.size() < 3)
        refuse("profile_radii", "must have as many numbers as profile_fractions, three at least");
    if (!std::is_sorted(recipe.fractions.begin(), recipe.fractions.end()))
        refuse("profile_fractions", "must rise");
    if (*std::min_element(recipe.radii.begin(), recipe.radii.end()) <= recipe.wall)
        refuse("wall", "must be thinner than the smallest radius");
    if (recipe.outer_rings.size() < 2 || recipe.inner_rings.size() < 2)
        refuse("outer_rings", "and inner_rings need two numbers each at least");
    return recipe;
}

ColumnRecipe readColumn(const toml::table& table) {
    ColumnRecipe recipe;
    recipe.sectors = readSectors(table);
    recipe.fine_crease_degrees = readNumber(table, "fine_crease_degrees");
    const toml::array* rings = table["rings"].as_array();
    if (!rings || rings->size() < 2) refuse("rings", "must be a list of two rings at least");
    for (const auto& node : *rings) {
        const toml::array* ring = node.as_array();
        if (!ring || ring->size() != 3) refuse("rings", "must hold [radius, y, shape] each");
        const auto radius = (*ring)[0].value<double>(), y = (*ring)[1].value<double>();
        if (!radius || !y || !(*radius > 0))
            refuse("rings", "must hold a radius greater than 0 and a height");
        recipe.rings.push_back({*radius, *y, readShape((*ring)[2].value_or(std::string()))});
    }
    return recipe;
}

}  // namespace demolish::sculptor
