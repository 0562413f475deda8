// SPDX-License-Identifier: Apache-2.0
// Fragments of the scene, by themselves.
#include "sim_cuda/solver/fragments.h"

#include <gtest/gtest.h>

#include "sim_cuda/backend/cpu_backend.h"
#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {
namespace {

/// Decisions ask how long ago something came off. A brick that has come off its mortar is a piece like any
/// other to them, and whole to the picture.
TEST(Fragments, ABrickGrowsOlderFromWhenItCameOffItsMortar) {
    SceneSetup setup = freeBody(latticeBody(2, 1, 1, 0.1));
    setup.bodies.push_back(setup.bodies[0]);
    setup.bodies[1].position.y += 0.1;
    const SceneTables apart = buildSceneTables(setup, {});
    for (const bool mortar : {false, true}) {
        if (mortar) setup.mortar = Mortar{};
        CpuBackend backend;
        SolverData<CpuBackend, float> data(backend, apart, 0);
        Fragments<CpuBackend, float> fragments(backend, apart.counts, setup);
        fragments.follow(data);
        for (const uint32_t frames : {1u, 2u, 3u}) {
            fragments.advanceAges();
            EXPECT_EQ(fragments.motion.ages()[2], mortar ? frames : 0u);
            EXPECT_EQ(fragments.drawn().motion.ages()[2], 0u);
        }
    }
}

}  // namespace
}  // namespace demolish::tests
