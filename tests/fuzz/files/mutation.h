// SPDX-License-Identifier: Apache-2.0
// Damage to files, as disks, downloads, editors and ill will do it.
#pragma once
#include <string>

#include "tests/fuzz/support/dice.h"

namespace demolish::fuzz {

/// One to four kinds of damage after each other: bits turned, ends and middles cut, parts twice, numbers huge
/// or none, deep nesting, keys twice, long lines, zeros, another byte order.
std::string mutated(std::string bytes, Dice& dice);

}  // namespace demolish::fuzz
