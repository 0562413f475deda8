// SPDX-License-Identifier: Apache-2.0
// Hair as ridges in a body's signed distance: what turns a smooth animal into a furred one (assets.md 1.4).
#pragma once
#include <limits>
#include <vector>

#include "assets/models/vec3.h"

namespace demolish::sculptor {

/// 0 at `from`, 1 at `to` (which may be the smaller one), smooth between, along axis 0 x, 1 y or 2 z.
struct Ramp {
    int axis = 1;
    double from = 0, to = 1;

    double at(Vec3 p) const;
};

/// How the hair lies where z < below_z and no earlier region holds.
struct CoatRegion {
    double below_z = std::numeric_limits<double>::infinity();
    Vec3 lie;                 ///< direction of the hairs; ridges are long along it
    Vec3 across;              ///< up the fur, square to the lie and to x
    std::vector<Ramp> fades;  ///< their product scales the ridges
};

struct Coat {
    struct Richer {
        Ramp ramp;
        double gain = 0;
    };
    double height = 0;  ///< of the ridges, in the recipe's unit
    double reach = 0;   ///< distance from the surface beyond which nothing is changed
    std::vector<CoatRegion> regions;
    std::vector<Richer> richer;  ///< the ridges grow by the sum of these
};

/// Smooth noise in [0, 1] with a hashed value on every lattice point of unit spacing.
double valueNoise(Vec3 p);

/// What to take from the signed distance at `p` (positive: the surface moves outwards).
double coatRelief(const Coat& coat, Vec3 p);

}  // namespace demolish::sculptor
