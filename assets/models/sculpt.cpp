// SPDX-License-Identifier: Apache-2.0
// The order of the work for each kind of recipe.
#include "assets/models/sculpt.h"

#include <algorithm>
#include <stdexcept>

#include "assets/models/collapse.h"
#include "assets/models/lathe.h"
#include "assets/models/marching.h"
#include "assets/models/relax.h"

namespace demolish::sculptor {
namespace {

bool contains(const DetailBox& box, Vec3 p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y &&
           p.z >= box.low.z && p.z <= box.high.z;
}

Model sculptField(const FieldRecipe& recipe, std::size_t triangles) {
    constexpr int kRelaxations = 6;
    const Field field(recipe);
    Surface surface =
        largestPart(marchTetrahedra([&](Vec3 p) { return field.at(p); }, field.bounds(), recipe.grid));
    relax(surface, field, recipe.grid, kRelaxations);
    Model model;
    model.surface = collapseTo(surface, triangles, [&](Vec3 p) {
        double weight = 1;
        for (const DetailBox& box : recipe.details)
            if (contains(box, p)) weight = std::max(weight, box.factor);
        return weight;
    });
    model.uvs = sphericalUvs(model.surface);
    return model;
}

Model fromTurned(Turned turned) {
    return {std::move(turned.surface), {}, std::move(turned.uvs)};
}

void standOnGround(Surface& surface, double unit_m) {
    double lowest = surface.positions.front().y;
    for (const Vec3 p : surface.positions) lowest = std::min(lowest, p.y);
    for (Vec3& p : surface.positions) p = unit_m * (p - Vec3{0, lowest, 0});
}

}  // namespace

Model sculpt(const Recipe& recipe, std::size_t triangles) {
    Model model;
    double crease_degrees = recipe.crease_degrees;
    if (const auto* field = std::get_if<FieldRecipe>(&recipe.body)) {
        model = sculptField(*field, triangles);
    } else if (const auto* vessel = std::get_if<VesselRecipe>(&recipe.body)) {
        model = fromTurned(turnVessel(*vessel, triangles));
    } else {
        const auto& column = std::get<ColumnRecipe>(recipe.body);
        model = fromTurned(turnColumn(column, triangles));
        if (isDivided(column, triangles)) crease_degrees = column.fine_crease_degrees;
    }
    standOnGround(model.surface, recipe.unit_m);
    const Topology topology = topologyOf(model.surface);
    if (!topology.closed || topology.euler != 2 || topology.parts != 1)
        throw std::runtime_error("the recipe's body has a hole, a handle or several parts (Euler number " +
                                 std::to_string(topology.euler) + ")");
    model.normals = cornerNormals(model.surface, crease_degrees);
    return model;
}

}  // namespace demolish::sculptor
