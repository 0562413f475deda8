// SPDX-License-Identifier: Apache-2.0
// How wide contact lists are made and how long they shall last.
#pragma once

namespace demolish {

struct NeighbourSettings {
    double skin_share = 0.5;     ///< skin of a particle over its R_c, 0.1..1: wider lists, fewer builds
    double travel_share = 1;     ///< largest travel within a horizon over the largest reach of two particles
    double longest_horizon = 1;  ///< s, at rest
    double shot_travel = 4;      ///< largest travel of a projectile over that reach
    double blind_time = 0;       ///< s, from a hit until the lists know of it
};

/// While something is moved as a rigid body: every build brings a new decision, so that lists have to last
/// longer; but long rows are gone through in every contact step.
inline constexpr NeighbourSettings kRigidNeighbours{0.75, 1, 0.012, 40};

}  // namespace demolish
