// SPDX-License-Identifier: Apache-2.0
// One rod of triangles for all of them, stretched from end to end.
#include "app/session/cables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/session/shot_geometry.h"

namespace demolish {
namespace {

constexpr int kSides = 16;

void addCorner(engine::ColliderTriangles& triangles, double angle, float z) {
    const auto x = static_cast<float>(std::cos(angle)), y = static_cast<float>(std::sin(angle));
    for (const float number : {x, y, z, x, y, 0.0f}) triangles.push_back(number);
}

/// Of radius 1 about the z axis, from -1 to 1; without ends, which lie in what it hangs on, or out of sight.
std::shared_ptr<const engine::ColliderTriangles> rod() {
    static const auto made = [] {
        auto triangles = std::make_shared<engine::ColliderTriangles>();
        for (int side = 0; side < kSides; ++side) {
            const double a = 2 * std::numbers::pi * side / kSides,
                         b = 2 * std::numbers::pi * (side + 1) / kSides;
            for (const auto& [angle, z] : {std::pair(a, -1.0f), {b, -1.0f}, {b, 1.0f}})
                addCorner(*triangles, angle, z);
            for (const auto& [angle, z] : {std::pair(a, -1.0f), {b, 1.0f}, {a, 1.0f}})
                addCorner(*triangles, angle, z);
        }
        return triangles;
    }();
    return made;
}

engine::ColliderDraw stretched(const glm::dvec3& from, const glm::dvec3& to, double radius) {
    const glm::dvec3 line = to - from;
    const double length = std::max(glm::length(line), 1e-9);
    const glm::dvec3 up = std::abs(line.y) < 0.9 * length ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    engine::ColliderDraw draw;
    draw.position = glm::vec3(0.5 * (from + to));
    draw.rotation = glm::quat(glm::quatLookAt(-line / length, up));
    draw.half_size = glm::vec3(radius, radius, 0.5 * length);
    draw.triangles = rod();
    draw.is_steel = true;
    return draw;
}

}  // namespace

std::vector<engine::ColliderDraw> drawnCables(const Shot& shot, double time) {
    std::vector<engine::ColliderDraw> list;
    for (const SceneBody& body : shot.bodies) {
        if (!body.cable || body.hidden) continue;
        const Double3 start = fromGlm(toGlm(body.position) + turnOf(body) * toGlm(body.cable->at));
        const Double3 at = placeOnPath(body.path, body.position, start, time);
        list.push_back(stretched(shot.height * toGlm(at), shot.height * toGlm(body.cable->to),
                                 shot.height * body.cable->radius));
    }
    return list;
}

}  // namespace demolish
