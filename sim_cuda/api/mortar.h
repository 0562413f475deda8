// SPDX-License-Identifier: Apache-2.0
// What joins bodies that stand against each other: walls of bricks, arches of stones.
#pragma once

namespace demolish {

/// Cells of different bodies with the same BodyInstance::rotation are bonded where their faces lie against
/// each other at the start; who wants bodies joined that are turned against each other turns them in their
/// frames (turned_body.h).
struct Mortar {
    /// Pa, of the real mortar: a joint is as strong as this is beside the tensile strength of the material;
    /// of two materials, beside that which gives the weaker joint.
    double tensile_strength = 0.3e6;
    double joint = 0.002;  ///< m: faces no farther apart than this are joined
    bool operator==(const Mortar&) const = default;
};

}  // namespace demolish
