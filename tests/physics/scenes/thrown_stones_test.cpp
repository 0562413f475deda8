// SPDX-License-Identifier: Apache-2.0
// Stones of 13 kg that are thrown lie still soon, and do not jump.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/session/data_folder.h"
#include "app/session/scene_file.h"
#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

constexpr double kHighest = 0.2;  // m, of a middle that has been below it once; they fall from 0.9
constexpr uint32_t kStones = 6, kCells = 500;

/// Cubes, one of which never breaks, a brick and a stone of an arch, too strong to break.
Shot thrownStones() {
    const std::string scene = R"(
version = 1
title = "Stones of 13 kg are thrown"
model = "models/block.obj"
height_m = 0.1703
material_preset = "stone"
body = [
    { position_m = [-6, 0.9, 0], velocity_mps = [0, 0, 3], spin_radps = [5, 1, 2] },
    { position_m = [-4, 0.9, 0], velocity_mps = [0, 0, 3], spin_radps = [5, 1, 2], rotation_deg = [30, 20, 10] },
    { position_m = [-2, 0.9, 0], velocity_mps = [0, -1, 4], spin_radps = [-5, 3, 2], rotation_deg = [60, 45, 10] },
    { position_m = [0, 0.9, 0], velocity_mps = [0, 0, 3], spin_radps = [5, 1, 2], rotation_deg = [30, 20, 10], breaks = false },
    { model = "models/brick.obj", height_m = 0.0964, position_m = [2, 0.9, 0], velocity_mps = [0, 0, 3], spin_radps = [5, 1, 2], rotation_deg = [0, 0, 50] },
    { model = "models/bevelled_voussoir.obj", height_m = 0.1688, position_m = [4, 0.9, 0], velocity_mps = [0, -1, 4], spin_radps = [5, 1, 2], rotation_deg = [40, 80, 0] },
]
[particles]
full = 500
draft = 500
seed = 1
[material]
critical_velocity_mps = 30
[solver]
wave_speed_mps = 190
settle_s = 0
[impact]
velocity_mps = 0
)";
    Shot shot = loadSceneText(scene, dataFolder() / "assets" / "scenes" / "thrown.toml");
    shot.device = DeviceChoice::kCpu;
    return shot;
}

struct Stone {
    double height = 0;  ///< m, of its middle
    double speed = 0;   ///< m/s, of its fastest cell in this frame
};
std::vector<Stone> stonesBetween(const std::vector<Float3>& before, const std::vector<Float3>& after,
                                 double seconds) {
    std::vector<Stone> stones(kStones);
    for (size_t i = 0; i < after.size(); ++i) {
        Stone& stone = stones[i / kCells];
        stone.height += after[i].y / kCells;
        stone.speed = std::max(stone.speed, farthest({before[i]}, {after[i]}) / seconds);
    }
    return stones;
}

TEST(ThrownStones, LieStillWithinTwoSecondsAndDoNotJump) {
    SceneRun run(thrownStones());
    EXPECT_NEAR(run.measured().mass, kStones * 13.0, kStones);
    constexpr double kFrame = 1.0 / 60;
    std::vector<double> landed(kStones, 0), still(kStones, 0), highest(kStones, 0);
    std::vector<Float3> before = run.positions();
    for (uint32_t frame = 1; frame < 180; ++frame) {
        const double time = frame * kFrame;
        run.runTo(time);
        const std::vector<Float3> after = run.positions();
        const std::vector<Stone> stones = stonesBetween(before, after, kFrame);
        for (uint32_t k = 0; k < kStones; ++k) {
            if (landed[k] == 0 && stones[k].height < kHighest) landed[k] = time;
            if (landed[k] == 0) continue;
            if (stones[k].speed > 0.02) still[k] = time - landed[k];
            highest[k] = std::max(highest[k], stones[k].height);
        }
        before = after;
    }
    EXPECT_EQ(run.stats().bonds_broken, 0u);
    for (uint32_t k = 0; k < kStones; ++k) {
        std::printf("stone %u: still after %.2f s, its middle no higher than %.3f m\n", k, still[k],
                    highest[k]);
        EXPECT_GT(landed[k], 0) << k;
        EXPECT_LT(still[k], 2) << k;
        EXPECT_LT(highest[k], kHighest) << k;
    }
}

}  // namespace
}  // namespace demolish::tests
