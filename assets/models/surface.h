// SPDX-License-Identifier: Apache-2.0
// A closed triangle surface and the questions that decide whether it is sound.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "assets/models/vec3.h"

namespace demolish::sculptor {

using Triangle = std::array<std::uint32_t, 3>;

/// Triangles are counterclockwise seen from outside.
struct Surface {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
};

struct Topology {
    bool closed = false;     ///< every edge has two triangles that pass it in opposite directions
    std::int64_t euler = 0;  ///< V - E + F over the vertices in use; 2 for one closed part without handles
    int parts = 0;           ///< connected through shared vertices
};

Topology topologyOf(const Surface& surface);

/// Enclosed volume in cubed units; negative when the surface is inside out.
double volumeOf(const Surface& surface);

/// Twice the area times the unit normal of a triangle.
Vec3 areaNormal(const Surface& surface, const Triangle& triangle);

/// The connected part with the most triangles (the first on a tie), vertices renumbered in their order.
Surface largestPart(const Surface& surface);

}  // namespace demolish::sculptor
