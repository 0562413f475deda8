// SPDX-License-Identifier: Apache-2.0
// Reads typed values out of a recipe's tables and names the key when one is missing or out of range.
#pragma once
#include <toml++/toml.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "assets/models/recipe.h"

namespace demolish::sculptor {

[[noreturn]] inline void refuse(std::string_view key, const std::string& reason) {
    throw std::runtime_error("'" + std::string(key) + "' " + reason);
}

inline double readNumber(const toml::table& table, std::string_view key) {
    const auto value = table[key].value<double>();
    if (!value) refuse(key, "must be a number");
    return *value;
}

inline double readPositive(const toml::table& table, std::string_view key) {
    const double value = readNumber(table, key);
    if (!(value > 0)) refuse(key, "must be greater than 0");
    return value;
}

inline int readSectors(const toml::table& table) {
    const auto value = table["sectors"].value<int>();
    if (!value || *value < 4 || *value % 2 != 0) refuse("sectors", "must be an even number, 4 at least");
    return *value;
}

inline std::vector<double> readNumbers(const toml::table& table, std::string_view key) {
    const toml::array* array = table[key].as_array();
    if (!array) refuse(key, "must be a list of numbers");
    std::vector<double> numbers;
    for (const auto& node : *array) {
        const auto value = node.value<double>();
        if (!value) refuse(key, "must hold numbers only");
        numbers.push_back(*value);
    }
    return numbers;
}

inline Vec3 readPoint(const toml::table& table, std::string_view key) {
    const auto numbers = readNumbers(table, key);
    if (numbers.size() != 3) refuse(key, "must be three numbers");
    return {numbers[0], numbers[1], numbers[2]};
}

/// The tables of a list; none when the key is missing.
inline std::vector<const toml::table*> readTables(const toml::table& table, std::string_view key) {
    std::vector<const toml::table*> tables;
    if (!table.contains(key)) return tables;
    const toml::array* array = table[key].as_array();
    if (!array) refuse(key, "must be a list of tables");
    for (const auto& node : *array) {
        if (!node.is_table()) refuse(key, "must be a list of tables");
        tables.push_back(node.as_table());
    }
    return tables;
}

Coat readCoat(const toml::table& table);
VesselRecipe readVessel(const toml::table& table);
ColumnRecipe readColumn(const toml::table& table);

}  // namespace demolish::sculptor
