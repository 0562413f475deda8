// SPDX-License-Identifier: Apache-2.0
// One shot has one state, whoever watches: energies measured or booked, frames exported, hashes asked for.
#include <gtest/gtest.h>

#include <functional>

#include "app/commands/shot_options.h"
#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

constexpr double kFps = 120;
constexpr int kFrames = 60;

/// A wolf that is dropped hard at coarse steps: pairs part by more than a skin in one of them.
Shot droppedWolf() {
    ShotOptions options;
    options.scene = "wolf";
    options.device = "cpu";
    options.particles = 2000;
    options.drop = 4.6;
    options.substeps = 20;
    options.fps = kFps;
    options.seed = 5375;
    return makeShot(options, "paper");
}

uint64_t hashAfter(const SceneRunOptions& options, const std::function<void(SceneRun&)>& watch) {
    SceneRun run(droppedWolf(), options);
    for (int frame = 1; frame <= kFrames; ++frame) {
        run.runTo(frame / kFps);
        watch(run);
    }
    EXPECT_GT(run.stats().bonds_broken, 100u);
    return run.stateHash();
}

TEST(Watching, ChangesNoBit) {
    const uint64_t alone = hashAfter({}, [](SceneRun&) {});
    EXPECT_EQ(hashAfter({}, [](SceneRun& run) { run.measured(); }), alone) << "measured";
    EXPECT_EQ(hashAfter({}, [](SceneRun& run) { run.positions(); }), alone) << "exported";
    EXPECT_EQ(hashAfter({.ledger = true},
                        [](SceneRun& run) {
                            run.measured();
                            run.energy();
                            run.positions();
                            run.stateHash();
                        }),
              alone)
        << "all at once, with the ledger";
}

}  // namespace
}  // namespace demolish::tests
