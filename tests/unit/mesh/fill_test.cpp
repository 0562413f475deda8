// SPDX-License-Identifier: Apache-2.0
// The whole way from a model file to a breakable body: conserved figures, progress, cancel, refusals.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/model_file.h"
#include "tests/unit/mesh/mesh_files.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

class FillTest : public test::FileTest {
  protected:
    std::shared_ptr<const SolidMesh> load(const TriangleMesh& mesh) const {
        return loadSolidMesh(write(mesh.name + ".obj", test::objText(mesh)), {.height = 0.5});
    }
};

TEST_F(FillTest, BodyHasTheMassOfTheMesh) {
    for (const TriangleMesh& mesh :
         {test::makeCube(1), test::makeTorus(1, 0.3, 40, 20), test::makeVase(50, 30)}) {
        SCOPED_TRACE(mesh.name);
        const auto solid = load(mesh);
        const auto body = fillWithParticles(*solid, {.particles = 400});
        const SolidMeshInfo& info = meshInfo(*solid);
        EXPECT_EQ(body->name, mesh.name);
        EXPECT_EQ(body->particles.size(), 400u);
        EXPECT_EQ(body->open_cells, 0u);
        EXPECT_NEAR(body->cells_volume / info.volume, 1, 1e-9);
        EXPECT_NEAR(std::pow(body->spacing, 3) * 400 / info.volume, 1, 1e-12);
        EXPECT_EQ(body->mesh_volume, info.volume);
        EXPECT_EQ(body->mesh_area, info.area);
        EXPECT_GT(body->bonds.size(), 400u);
        EXPECT_GT(body->geometry.exterior.size(), 0u);
        EXPECT_GT(body->geometry.faces.size(), 0u);
    }
}

TEST_F(FillTest, NoDrawGeometryWhenNotAskedFor) {
    const auto body = fillWithParticles(*load(test::makeCube(1)), {.particles = 50, .draw_geometry = false});
    EXPECT_TRUE(body->geometry.exterior.empty());
    EXPECT_TRUE(body->geometry.faces.empty());
    EXPECT_EQ(body->particles.size(), 50u);
}

TEST_F(FillTest, ProgressRisesToOneAndCancelStopsAnywhere) {
    const auto solid = load(test::makeCube(1));
    double last = -1;
    int calls = 0;
    fillWithParticles(*solid, {.particles = 50}, [&](double fraction, const char* stage) {
        EXPECT_GE(fraction, last);
        EXPECT_GT(std::strlen(stage), 0u);
        last = fraction;
        ++calls;
        return true;
    });
    EXPECT_EQ(last, 1);
    for (int stop = 1; stop <= calls; ++stop) {
        int seen = 0;
        EXPECT_THROW(
            fillWithParticles(*solid, {.particles = 50}, [&](double, const char*) { return ++seen < stop; }),
            Cancelled);
        EXPECT_EQ(seen, stop);
    }
}

TEST_F(FillTest, CountsOutOfRangeAreRefused) {
    const auto solid = load(test::makeCube(1));
    for (const uint32_t count : {0u, kMinParticles - 1, kMaxParticles + 1})
        EXPECT_THROW(fillWithParticles(*solid, {.particles = count}), UsageError);
    EXPECT_EQ(fillWithParticles(*solid, {.particles = kMinParticles})->particles.size(), kMinParticles);
}

/// A box that is inside out sticks out of a wall: beyond the wall it counts less than nothing.
TEST_F(FillTest, CellsWithoutVolumeAreRefused) {
    TriangleMesh mesh =
        test::joined(test::makeCube(1), test::turnedInsideOut(test::makeCube(0.6)), {0.5, 0, 0});
    MeshPlacement exact{.height = 0.5};
    exact.repair.mode = RepairMode::kExact;
    const auto solid = makeSolidMesh(mesh, "inside_out.obj", exact);
    EXPECT_THROW(fillWithParticles(*solid, {.particles = 1000}), InputFileError);
}

TEST_F(FillTest, SameBodyForOneAndTwoThreads) {
    const auto solid = load(test::makeTorus(1, 0.3, 40, 20));
    const auto make = [&](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return fillWithParticles(*solid, {.particles = 600, .seed = 5});
    };
    const auto one = make(1), two = make(2);
    ASSERT_EQ(one->particles.size(), two->particles.size());
    EXPECT_EQ(
        std::memcmp(one->particles.data(), two->particles.data(), one->particles.size() * sizeof(Particle)),
        0);
    ASSERT_EQ(one->bonds.size(), two->bonds.size());
    for (size_t b = 0; b < one->bonds.size(); ++b) {
        ASSERT_EQ(one->bonds[b].i, two->bonds[b].i);
        ASSERT_EQ(one->bonds[b].j, two->bonds[b].j);
        ASSERT_EQ(one->bonds[b].area, two->bonds[b].area);
        ASSERT_EQ(one->bonds[b].length, two->bonds[b].length);
    }
    EXPECT_EQ(one->geometry.face_indices, two->geometry.face_indices);
    EXPECT_EQ(one->geometry.exterior_indices, two->geometry.exterior_indices);
}

}  // namespace
}  // namespace demolish
