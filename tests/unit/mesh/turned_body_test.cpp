// SPDX-License-Identifier: Apache-2.0
// A body turned in its frame is the same body.
#include "sim_cuda/api/turned_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/physics/vertex_unpacking.h"

namespace demolish {
namespace {

const Quaternion kQuarter{0, 0, std::sqrt(0.5), std::sqrt(0.5)};  // x to y, y to -x

std::shared_ptr<const BreakableBody> brick() {
    return fillWithParticles(*loadSolidMesh(DEMOLISH_SOURCE_DIR "/assets/models/brick.obj"),
                             {.particles = 40});
}

TEST(TurnedBody, CellsBondsAndOutsideGoAlong) {
    const auto body = brick(), turned = turnedBody(*body, kQuarter);
    ASSERT_EQ(turned->particles.size(), body->particles.size());
    for (size_t i = 0; i < body->particles.size(); ++i) {
        const Particle &a = body->particles[i], &b = turned->particles[i];
        EXPECT_NEAR(b.seed.x, -a.seed.y, 1e-12);
        EXPECT_NEAR(b.seed.y, a.seed.x, 1e-12);
        EXPECT_NEAR(b.centroid.y, a.centroid.x, 1e-12);
        EXPECT_NEAR(b.inertia.xx, a.inertia.yy, 1e-12 * a.inertia.yy);
        EXPECT_NEAR(b.inertia.xy, -a.inertia.xy, 1e-9 * a.inertia.yy);
        EXPECT_NEAR(b.inertia.yz, a.inertia.zx, 1e-9 * a.inertia.yy);
        EXPECT_NEAR(b.inertia.zx, -a.inertia.yz, 1e-9 * a.inertia.yy);
        EXPECT_EQ(b.volume, a.volume);
    }
    for (size_t k = 0; k < body->bonds.size(); ++k)
        EXPECT_NEAR(turned->bonds[k].normal.y, body->bonds[k].normal.x, 1e-12);
    EXPECT_NEAR(turned->bounds_max.y, body->bounds_max.x, 1e-6);
    EXPECT_NEAR(turned->bounds_min.x, -body->bounds_max.y, 1e-6);
    const FractureGeometry &was = body->geometry, &is = turned->geometry;
    for (size_t v = 0; v < was.exterior.size(); ++v) {
        EXPECT_NEAR(is.exterior[v].position.y, was.exterior[v].position.x, 1e-6);
        const Vec3<float> before = unpackOctahedral(was.exterior[v].normal),
                          after = unpackOctahedral(is.exterior[v].normal);
        EXPECT_NEAR(after.y, before.x, 1e-4);
    }
    for (size_t t = 0; t < was.mesh_triangles.size(); ++t)
        EXPECT_NEAR(is.mesh_triangles[t].corner[1].y, was.mesh_triangles[t].corner[1].x, 1e-6);
    for (size_t p = 0; p < was.points.size(); ++p)
        EXPECT_NEAR(is.points[p].axis.y, was.points[p].axis.x, 1e-6);
    for (size_t p = 0; p < was.pool.size(); ++p) EXPECT_NEAR(is.pool[p].y, was.pool[p].x, 1e-6);
}

TEST(TurnedBody, TheLowestPointOfACellIsFoundAgain) {
    const auto body = brick(), turned = turnedBody(*body, kQuarter);
    double lowest = 1e300;
    for (const Particle& particle : turned->particles) lowest = std::min(lowest, particle.lowest);
    EXPECT_NEAR(lowest, body->bounds_min.x, 1e-3 * body->bounds_max.y);
}

}  // namespace
}  // namespace demolish
