// SPDX-License-Identifier: Apache-2.0
// What a recipe file says, checked: a body of blended shapes, a vessel, or a column.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "assets/models/coat.h"
#include "assets/models/primitives.h"

namespace demolish::sculptor {

enum class PartKind { kEllipsoid, kCone, kBlade };

/// One shape; lengths in the recipe's unit.
struct Part {
    PartKind kind = PartKind::kEllipsoid;
    Vec3 a;            ///< centre of the ellipsoid, or the cone's first end
    Vec3 radii;        ///< ellipsoid only
    double ra = 0;     ///< cone and blade
    Vec3 b;            ///< cone and blade: second end
    double rb = 0;     ///< cone and blade
    double flat = 1;   ///< blade only: thickness against width
    Turn turn;         ///< of an ellipsoid or a blade
    double blend = 0;  ///< radius of the smooth operation; 0: sharp
    bool mirrored = false;
    bool carves = false;  ///< taken away instead of added
};

/// Where the decimation may err less: its error counts `factor` times in the box.
struct DetailBox {
    Vec3 low, high;
    double factor = 1;
};

struct FieldRecipe {
    double grid = 0;  ///< edge of a marching cube
    std::vector<Part> parts;
    std::optional<Coat> coat;
    std::vector<DetailBox> details;
};

/// Thin-walled vessel; lengths in the recipe's unit, fractions of the height.
struct VesselRecipe {
    double height = 0, wall = 0, rim_rise = 0, inner_bottom = 0;
    std::vector<double> fractions, radii;  ///< outer profile, a cubic through these points
    std::vector<double> outer_rings, inner_rings;
    int sectors = 0;  ///< at the recipe's own ring count
};

enum class RingShape { kRound, kSquare, kFluted };

struct Ring {
    double radius = 0, y = 0;
    RingShape shape = RingShape::kRound;
};

struct ColumnRecipe {
    std::vector<Ring> rings;
    int sectors = 0;
    double fine_crease_degrees =
        0;  ///< in place of the recipe's where the column is made finer than its rings
};

struct Recipe {
    double unit_m = 1;          ///< metres in one unit of the recipe
    double crease_degrees = 0;  ///< faces that meet at less share a normal; 180: smooth everywhere, 0: flat
    std::variant<FieldRecipe, VesselRecipe, ColumnRecipe> body;
};

/// Throws std::runtime_error with file, key and reason when the file cannot be read or a value makes no
/// sense.
Recipe readRecipe(const std::filesystem::path& file);

}  // namespace demolish::sculptor
