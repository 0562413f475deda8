// SPDX-License-Identifier: Apache-2.0
// The body of a recipe as one signed distance: its parts joined and carved in order.
#pragma once
#include <vector>

#include "assets/models/recipe.h"

namespace demolish::sculptor {

struct Box {
    Vec3 low, high;
};

/// Immutable, so any number of threads may ask it. Lengths in the recipe's unit.
class Field {
  public:
    explicit Field(const FieldRecipe& recipe);

    /// Signed distance, negative inside; exact in sign, approximate in size (ellipsoids and blends are).
    double at(Vec3 p) const;

    /// Gradient by central differences of step `h`.
    Vec3 gradient(Vec3 p, double h) const;

    /// A box that holds the whole body.
    Box bounds() const { return bounds_; }

  private:
    struct Prepared {
        Part part;
        Frame frame;
        Vec3 end;  ///< second end of a blade in its own coordinates
        /// The part's distance is nowhere less than slope * |p - centre| - offset.
        Vec3 centre;
        double slope = 0, offset = 0;
    };
    static Prepared prepare(const Part& part);
    static double leastDistance(const Prepared& prepared, Vec3 p);
    static double distance(const Prepared& prepared, Vec3 p);

    std::vector<Prepared> parts_;
    std::optional<Coat> coat_;
    Box bounds_;
};

}  // namespace demolish::sculptor
