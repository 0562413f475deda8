// SPDX-License-Identifier: Apache-2.0
// Pieces that have come to rest lie on what is drawn of them, not in the floor (models.md E.4).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>

#include "app/bridge/host_frame.h"
#include "app/session/session.h"
#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

/// One body of the scene, dropped so that it breaks.
Shot dropped(const std::string& scene, uint32_t particles, double speed, uint64_t packing) {
    Shot shot = smallScene(scene, particles);
    if (shot.bodies.size() > 1) shot = smallScene(scene, particles, {0});
    shot.seed += packing;
    shot.effects.on = false;  // single cells are drawn as large as they are
    shot.impact.kind = ImpactKind::kDrop;
    shot.impact.times_threshold.reset();
    shot.impact.velocity = speed;
    return shot;
}

/// Of each piece that lies on the floor: how far its lowest drawn vertex is below it, in spacings.
std::vector<double> depthsOnFloor(Session& session) {
    const BuiltShot& built = session.built();
    const BreakableBody& body = *built.body;
    const HostFrame frame = readFrame(session.solver(), FrameParts::kFragments | FrameParts::kTransforms);
    std::map<uint32_t, double> lowest;
    const auto see = [&](uint32_t cell, const Float3& p) {
        const uint32_t slot = frame.particle_fragment[cell];
        const FragmentTransform& t = frame.transforms[slot];
        const glm::dquat turn(t.rotation.w, t.rotation.x, t.rotation.y, t.rotation.z);
        const double y = (turn * glm::dvec3(p.x, p.y, p.z)).y + t.translation.y;
        const auto [at, is_new] = lowest.try_emplace(slot, y);
        if (!is_new) at->second = std::min(at->second, y);
    };
    const FractureGeometry& drawn = body.geometry;
    for (const SurfaceVertex& vertex : drawn.exterior) see(vertex.cell, vertex.position);
    for (const InteriorFace& face : drawn.faces)
        for (uint32_t k = 0; k < face.vertex_count; ++k) {
            const Float3& p = drawn.pool[drawn.face_vertices[face.first_vertex + k]];
            see(face.cell_a, p);
            see(face.cell_b, p);
        }
    std::vector<double> depths;
    for (const auto& [slot, y] : lowest)
        if (y < 0.3 * body.spacing) depths.push_back(std::max(0.0, -y) / body.spacing);
    return depths;
}

/// Spacings, of the pieces on the floor.
struct Depths {
    double worst = 0, mean = 0;
};
Depths depthsAtRest(const Shot& shot) {
    Session session(buildShot(shot, {.draw_geometry = true}, {}), {.draw = false});
    while (session.solver().stats().time < 4) EXPECT_EQ(session.advance(), StepStatus::kOk);
    const std::vector<double> depths = depthsOnFloor(session);
    EXPECT_GT(depths.size(), 10u);
    Depths result;
    for (const double depth : depths) {
        result.worst = std::max(result.worst, depth);
        result.mean += depth / static_cast<double>(depths.size());
    }
    std::printf("%zu pieces on the floor, %.3f h deep at most, %.4f h on the mean; %u awake\n", depths.size(),
                result.worst, result.mean, session.solver().stats().awake_particles);
    return result;
}

/// The deepest is one cell of hundreds, on which others happen to press, so that packings differ by much:
/// means over four of them are held, and a bound for each.
TEST(Lying, WhatIsDrawnOfRestingPiecesLiesOnTheFloor) {
    constexpr uint64_t kPackings = 4;
    struct Row {
        const char* scene;
        uint32_t particles;
        double speed;  ///< m/s
    };
    for (const Row& row : {Row{"vase", 600, 8}, Row{"bunny", 400, 8}, Row{"column", 300, 6}}) {
        SCOPED_TRACE(row.scene);
        Depths over_packings;
        for (uint64_t packing = 0; packing < kPackings; ++packing) {
            std::printf("%s: ", row.scene);
            const Depths depths = depthsAtRest(dropped(row.scene, row.particles, row.speed, packing));
            EXPECT_LT(depths.worst, 0.12);
            over_packings.worst += depths.worst / kPackings;
            over_packings.mean += depths.mean / kPackings;
        }
        EXPECT_LT(over_packings.worst, 0.09);
        EXPECT_LT(over_packings.mean, 0.02);
    }
}

}  // namespace
}  // namespace demolish::tests
