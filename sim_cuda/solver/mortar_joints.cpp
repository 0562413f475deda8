// SPDX-License-Identifier: Apache-2.0
// Triangles of the outsides of two bodies, laid over each other where they face each other.
#include "sim_cuda/solver/mortar_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/solver/body_constants.h"

namespace demolish {
namespace {

/// Cosine of the angle between outsides that face each other, at most; and the least area of a bond, in h^2.
constexpr double kFacing = -0.95, kLeastArea = 0.02;

struct Corners3 {
    Vec3<double> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

    void add(const Vec3<double>& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    bool isNear(const Corners3& other, double gap) const {
        return low.x <= other.high.x + gap && other.low.x <= high.x + gap && low.y <= other.high.y + gap &&
               other.low.y <= high.y + gap && low.z <= other.high.z + gap && other.low.z <= high.z + gap;
    }
};

/// Of the outside of a cell, in the world.
struct OuterTriangle {
    uint32_t cell = 0;  ///< particle of the scene
    std::array<Vec3<double>, 3> corner;
    Vec3<double> normal;  ///< unit
    Corners3 box;
};

struct Outside {
    std::vector<OuterTriangle> triangles;
    Corners3 box;
};

Outside outsideOf(const BodyInstance& instance, uint32_t first) {
    Outside outside;
    const FractureGeometry& geometry = instance.body->geometry;
    const Quaternion& r = instance.rotation;
    const Quat<double> q = normalized(Quat<double>{r.x, r.y, r.z, r.w});
    const Vec3<double> at{instance.position.x, instance.position.y, instance.position.z};
    for (size_t k = 0; k + 2 < geometry.exterior_indices.size(); k += 3) {
        OuterTriangle triangle;
        for (size_t c = 0; c < 3; ++c) {
            const SurfaceVertex& vertex = geometry.exterior[geometry.exterior_indices[k + c]];
            triangle.cell = first + vertex.cell;
            triangle.corner[c] =
                at + rotate(q, Vec3<double>{vertex.position.x, vertex.position.y, vertex.position.z});
            triangle.box.add(triangle.corner[c]);
            outside.box.add(triangle.corner[c]);
        }
        const Vec3<double> across =
            cross(triangle.corner[1] - triangle.corner[0], triangle.corner[2] - triangle.corner[0]);
        const double twice = length(across);
        if (!(twice > 0)) continue;
        triangle.normal = (1 / twice) * across;
        outside.triangles.push_back(triangle);
    }
    return outside;
}

std::vector<const OuterTriangle*> nearTo(const Outside& outside, const Corners3& box, double gap) {
    std::vector<const OuterTriangle*> near;
    for (const OuterTriangle& triangle : outside.triangles)
        if (triangle.box.isNear(box, gap)) near.push_back(&triangle);
    return near;
}

double areaOf(const std::vector<Vec3<double>>& polygon, const Vec3<double>& normal) {
    double twice = 0;
    for (size_t k = 2; k < polygon.size(); ++k)
        twice += dot(normal, cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]));
    return 0.5 * std::fabs(twice);
}

/// m^2: of b, laid on the plane of a, within a.
double sharedArea(const OuterTriangle& a, const OuterTriangle& b) {
    std::vector<Vec3<double>> polygon;
    for (const Vec3<double>& corner : b.corner)
        polygon.push_back(axpy(-dot(a.normal, corner - a.corner[0]), a.normal, corner));
    for (size_t side = 0; side < 3 && !polygon.empty(); ++side) {
        const Vec3<double> from = a.corner[side], along = a.corner[(side + 1) % 3] - from;
        const Vec3<double> inward = cross(a.normal, along);
        std::vector<Vec3<double>> inside;
        for (size_t k = 0; k < polygon.size(); ++k) {
            const Vec3<double>&p = polygon[k], &next = polygon[(k + 1) % polygon.size()];
            const double depth = dot(inward, p - from), depth_next = dot(inward, next - from);
            if (depth >= 0) inside.push_back(p);
            if ((depth >= 0) != (depth_next >= 0))
                inside.push_back(axpy(depth / (depth - depth_next), next - p, p));
        }
        polygon = std::move(inside);
    }
    return polygon.size() < 3 ? 0 : areaOf(polygon, a.normal);
}

bool facesEachOther(const OuterTriangle& a, const OuterTriangle& b, double gap) {
    if (!a.box.isNear(b.box, gap) || dot(a.normal, b.normal) > kFacing) return false;
    const Vec3<double> middle = (1.0 / 3) * (b.corner[0] + b.corner[1] + b.corner[2]);
    return std::fabs(dot(a.normal, middle - a.corner[0])) <= gap;
}

using Areas = std::map<std::pair<uint32_t, uint32_t>, double>;

void addAreas(const Outside& a, const Outside& b, double gap, Areas& areas) {
    const auto of_b = nearTo(b, a.box, gap);
    for (const OuterTriangle* own : nearTo(a, b.box, gap))
        for (const OuterTriangle* other : of_b) {
            if (!facesEachOther(*own, *other, gap)) continue;
            const double area = sharedArea(*own, *other);
            if (area > 0) areas[{own->cell, other->cell}] += area;
        }
}

/// Strength by (13) hangs on the modulus, which bodies in mortar share.
bool mayJoin(const BodyInstance& a, const BodyInstance& b) {
    return a.in_mortar && b.in_mortar && a.rotation == b.rotation && a.material.fracture_energy == 0 &&
           b.material.fracture_energy == 0;
}

/// N/m, k_N at the trial modulus: that of the softer material.
double stiffnessAt(const MortarJoint& joint, const SceneSetup& setup, const SceneTables& tables) {
    BondGeometry bond;
    bond.area = joint.area;
    bond.length = length(tables.position[joint.j] - tables.position[joint.i]);
    const auto of = [&](uint32_t end) {
        return stiffnessOf(setup.bodies[tables.owner[end]].material, bond, kTrialModulus).normal;
    };
    return std::min(of(joint.i), of(joint.j));
}

/// A slot, and where it was before: joint k has the places 2 k and 2 k + 1 after all others.
struct Entry {
    BondSlot slot;
    size_t former = 0;
};

/// Per particle, by the id of the other end.
std::vector<std::vector<Entry>> rowsWith(const std::vector<MortarJoint>& joints, const SceneSetup& setup,
                                         const SceneTables& tables) {
    std::vector<std::vector<Entry>> rows(tables.counts.in_bodies);
    for (uint32_t i = 0; i < rows.size(); ++i)
        for (uint32_t s = tables.row_start[i]; s < tables.row_start[i + 1]; ++s)
            rows[i].push_back({tables.slots[s], s});
    const size_t former_slots = tables.slots.size();
    for (size_t k = 0; k < joints.size(); ++k) {
        const auto& [i, j, area, stiffness] = joints[k];
        const auto strength = [&](uint32_t end) {
            return setup.mortar->tensile_strength / setup.bodies[tables.owner[end]].material.tensile_strength;
        };
        const Vec3<double> rest =
            rotate(conjugate(tables.rotation[i]), tables.position[j] - tables.position[i]);
        const double radius = faceBondRadius(area);
        rows[i].push_back({{j, rest, stiffness, radius, strength(i)}, former_slots + 2 * k});
        rows[j].push_back({{i, -rest, stiffness, radius, strength(j)}, former_slots + 2 * k + 1});
    }
    for (std::vector<Entry>& row : rows)
        std::sort(row.begin(), row.end(),
                  [](const Entry& a, const Entry& b) { return a.slot.other < b.slot.other; });
    return rows;
}

}  // namespace

std::vector<MortarJoint> findJoints(const SceneSetup& setup, const SceneTables& tables) {
    std::vector<Outside> outside;
    uint32_t first = 0;
    for (const BodyInstance& instance : setup.bodies) {
        outside.push_back(outsideOf(instance, first));
        first += static_cast<uint32_t>(instance.body->particles.size());
    }
    const double gap = setup.mortar->joint;
    Areas areas;  // of the lower body's cell first, which is the lower one
    for (uint32_t a = 0; a < tables.bodies; ++a)
        for (uint32_t b = a + 1; b < tables.bodies; ++b)
            if (mayJoin(setup.bodies[a], setup.bodies[b]) && outside[a].box.isNear(outside[b].box, gap))
                addAreas(outside[a], outside[b], gap, areas);
    std::vector<MortarJoint> joints;
    for (const auto& [cells, area] : areas) {
        const double h = std::min(setup.bodies[tables.owner[cells.first]].body->spacing,
                                  setup.bodies[tables.owner[cells.second]].body->spacing);
        if (!(area > kLeastArea * h * h)) continue;
        joints.push_back({cells.first, cells.second, area, 0});
        joints.back().stiffness = stiffnessAt(joints.back(), setup, tables);
    }
    return joints;
}

void appendJoints(const std::vector<MortarJoint>& joints, const SceneSetup& setup, SceneTables& tables) {
    const auto rows = rowsWith(joints, setup, tables);
    const size_t former_slots = tables.slots.size();
    std::vector<uint32_t> place(former_slots + 2 * joints.size());
    std::vector<BondSlot> slots;
    for (size_t i = 0; i < rows.size(); ++i) {
        tables.row_start[i] = static_cast<uint32_t>(slots.size());
        for (const Entry& entry : rows[i]) {
            place[entry.former] = static_cast<uint32_t>(slots.size());
            slots.push_back(entry.slot);
        }
    }
    for (size_t i = rows.size(); i < tables.row_start.size(); ++i)
        tables.row_start[i] = static_cast<uint32_t>(slots.size());
    std::vector<uint32_t> twin(slots.size());
    for (size_t s = 0; s < former_slots; ++s) twin[place[s]] = place[tables.twin[s]];
    for (uint32_t& slot : tables.slot_of_bond) slot = place[slot];
    for (size_t k = 0; k < joints.size(); ++k) {
        const uint32_t here = place[former_slots + 2 * k], there = place[former_slots + 2 * k + 1];
        twin[here] = there;
        twin[there] = here;
        tables.slot_of_bond.push_back(here);
    }
    tables.twin = std::move(twin);
    tables.slots = std::move(slots);
}

}  // namespace demolish
