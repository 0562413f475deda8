// SPDX-License-Identifier: Apache-2.0
// Which particles the anchors of a set-up reach.
#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {
namespace {

Vec3<double> vec(const Double3& a) {
    return {a.x, a.y, a.z};
}

/// m, from a point to a region; not above 0 within it.
double distanceTo(const Anchor::Everything&, const Vec3<double>&) {
    return -1;
}
double distanceTo(const Box& box, const Vec3<double>& point) {
    const Quaternion& q = box.rotation;
    const Vec3<double> own =
        rotate(conjugate(normalized(Quat<double>{q.x, q.y, q.z, q.w})), point - vec(box.position));
    const auto beyond = [](double at, double edge) { return std::fmax(0.0, std::fabs(at) - 0.5 * edge); };
    return length(
        Vec3<double>{beyond(own.x, box.size.x), beyond(own.y, box.size.y), beyond(own.z, box.size.z)});
}
double distanceTo(const Sphere& ball, const Vec3<double>& point) {
    return length(point - vec(ball.position)) - ball.radius;
}

}  // namespace

bool reaches(const Anchor& anchor, uint32_t body, const Vec3<double>& point, double radius) {
    if (anchor.body.value_or(body) != body) return false;
    return std::visit([&](const auto& region) { return distanceTo(region, point) < radius; }, anchor.region);
}

void holdAnchored(const SceneSetup& setup, SceneTables& tables) {
    if (setup.anchors.empty()) return;
    std::vector<bool> holds(setup.anchors.size(), false);
    tables.anchor.assign(tables.position.size(), SceneTables::kNoAnchor);
    for (size_t i = 0; i < tables.position.size(); ++i)
        for (uint32_t a = 0; a < setup.anchors.size(); ++a) {
            if (!reaches(setup.anchors[a], tables.owner[i], tables.position[i], tables.contact_radius[i]))
                continue;
            holds[a] = true;
            if (tables.anchor[i] == SceneTables::kNoAnchor) tables.anchor[i] = a;
            tables.velocity[i] = tables.spin[i] = {};
        }
    for (size_t a = 0; a < holds.size(); ++a)
        if (!holds[a])
            throw InputFileError(
                "Anchor " + std::to_string(a) +
                " of the scene holds nothing (anchors are counted from 0, the scene's before "
                "those of its bodies); its region must reach into a body.");
}

}  // namespace demolish
