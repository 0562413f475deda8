// SPDX-License-Identifier: Apache-2.0
// From a recipe to a finished model.
#pragma once
#include "assets/models/obj_writer.h"
#include "assets/models/recipe.h"

namespace demolish::sculptor {

/// A closed model of genus 0 with exactly `triangles` triangles; the same bits on any number of threads.
/// Throws std::runtime_error when the recipe cannot give that: count out of reach, a handle or a hole in the
/// body.
Model sculpt(const Recipe& recipe, std::size_t triangles);

}  // namespace demolish::sculptor
