// SPDX-License-Identifier: Apache-2.0
// A scene out of dice: bodies that stand on each other, side by side and in mortar, that fly, are held or
// led, and what is shot at them.
#pragma once
#include <filesystem>
#include <string>

#include "tests/fuzz/support/dice.h"

namespace demolish::fuzz {

struct RandomSet {
    std::string text;            ///< of a scene file
    double smallest_volume = 0;  ///< m^3, of a body
};

/// Models are written to `models`.
RandomSet randomSet(Dice& dice, const std::filesystem::path& models);

}  // namespace demolish::fuzz
