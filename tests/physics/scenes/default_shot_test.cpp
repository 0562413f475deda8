// SPDX-License-Identifier: Apache-2.0
// The ball that a bare model gets breaks it, whichever way the file stands and however long its lengths are.
#include <gtest/gtest.h>

#include "app/session/model_shot.h"
#include "tests/physics/scenes/scene_run.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::tests {
namespace {

/// A box of 1 x 2 x 0.6 times `scale`.
std::string boxText(double scale) {
    std::string text;
    for (const double z : {0.0, 0.6})
        for (const double y : {0.0, 2.0})
            for (const double x : {0.0, 1.0})
                text += "v " + std::to_string(scale * x) + ' ' + std::to_string(scale * y) + ' ' +
                        std::to_string(scale * z) + '\n';
    return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

double brokenShare(const std::filesystem::path& file, UpAxis up, double unit) {
    Shot shot = modelShot(file);
    shot.part.up = up;
    setUnit(shot, unit);
    shot.device = DeviceChoice::kCpu;
    shot.fineness.particles = 300;
    shot.effects.on = false;
    SceneRun run(shot);
    run.runTo(0.25);
    return double(run.stats().bonds_broken) / double(run.stats().bonds);
}

TEST(DefaultShot, BreaksModelsOfAnyUnitThatLieOrStand) {
    const test::TemporaryFolder folder;
    const struct {
        const char* unit;  // "": not known
        double per_metre;
    } files[] = {{"", 37}, {"m", 1}, {"cm", 100}, {"mm", 1000}, {"in", 39.37}, {"ft", 3.281}};
    for (const auto& [unit, per_metre] : files)
        for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
            const auto file = folder.write("box.obj", boxText(per_metre));
            EXPECT_GT(brokenShare(file, up, lengthUnitOf(unit).value_or(0)), 0.05)
                << unit << (up == UpAxis::kZ ? ", z up" : ", y up");
        }
}

}  // namespace
}  // namespace demolish::tests
