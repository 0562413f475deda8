// SPDX-License-Identifier: Apache-2.0
// Recipe files: the coat.
#include "assets/models/recipe_values.h"

namespace demolish::sculptor {
namespace {

Ramp readRamp(const toml::table& table) {
    const auto axis = table["axis"].value_or(std::string());
    if (axis != "x" && axis != "y" && axis != "z") refuse("axis", "must be \"x\", \"y\" or \"z\"");
    const Ramp ramp{axis[0] - 'x', readNumber(table, "from"), readNumber(table, "to")};
    if (ramp.from == ramp.to) refuse("to", "must differ from 'from'");
    return ramp;
}

}  // namespace

Coat readCoat(const toml::table& table) {
    Coat coat;
    coat.height = readPositive(table, "height");
    coat.reach = readPositive(table, "reach");
    for (const toml::table* node : readTables(table, "richer"))
        coat.richer.push_back({readRamp(*node), readNumber(*node, "gain")});
    for (const toml::table* node : readTables(table, "region")) {
        CoatRegion region;
        if (node->contains("below_z")) region.below_z = readNumber(*node, "below_z");
        region.lie = readPoint(*node, "lie");
        region.across = readPoint(*node, "across");
        for (const toml::table* fade : readTables(*node, "fades")) region.fades.push_back(readRamp(*fade));
        coat.regions.push_back(region);
    }
    if (coat.regions.empty()) refuse("coat", "needs at least one region");
    return coat;
}

}  // namespace demolish::sculptor
