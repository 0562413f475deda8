// SPDX-License-Identifier: Apache-2.0
// A bar that is hit in its middle breaks where the artist painted a dark line.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "app/session/model_shot.h"
#include "sim_cuda/api/errors.h"
#include "tests/physics/scenes/scene_run.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::tests {
namespace {

constexpr double kLine = 0.5, kHalfWidth = 0.05;  // m
constexpr int kRings = 40;

/// A bar of 2 x 0.3 x 0.3 m along x, its vertices in rings 5 cm apart; white but for a dark ring at kLine,
/// where `painted`. Without any colour where `coloured` is false.
std::string barText(bool painted, bool coloured = true) {
    std::ostringstream text;
    for (int ring = 0; ring <= kRings; ++ring)
        for (int corner = 0; corner < 4; ++corner) {
            const double x = -1 + 2.0 * ring / kRings, a = corner == 1 || corner == 2 ? 0.15 : -0.15,
                         b = corner > 1 ? 0.15 : -0.15;
            const bool dark = painted && std::abs(x - kLine) < 0.01;
            text << "v " << x << ' ' << b << ' ' << a;
            if (coloured) text << (dark ? " 0 1 1" : " 1 1 1");
            text << '\n';
        }
    for (int ring = 0; ring < kRings; ++ring)
        for (int corner = 0; corner < 4; ++corner) {
            const int a = 4 * ring + corner + 1, b = 4 * ring + (corner + 1) % 4 + 1;
            text << "f " << a << ' ' << b << ' ' << b + 4 << ' ' << a + 4 << '\n';
        }
    text << "f 4 3 2 1\nf " << 4 * kRings + 1 << ' ' << 4 * kRings + 2 << ' ' << 4 * kRings + 3 << ' '
         << 4 * kRings + 4 << '\n';
    return text.str();
}

Shot barShot(const std::filesystem::path& file) {
    Shot shot = modelShot(file);
    setUnit(shot, 1);
    shot.device = DeviceChoice::kCpu;
    shot.fineness.particles = 1200;
    shot.impact.times_threshold.reset();
    shot.impact.velocity = 30;
    shot.material.tough_cells = 0;
    shot.effects.on = false;
    shot.painted = PaintedStrength{PaintChannel::kRed, 0.05};
    return shot;
}

/// Of the bonds between pieces: how many there are, and how many lie within a cell of the line.
struct Cracks {
    size_t all = 0, at_line = 0;
};

Cracks cracksOf(const Shot& shot) {
    SceneRun run(shot);
    run.runTo(0.25);
    const auto& body = *run.setup().bodies[0].body;
    const std::vector<uint32_t> fragment = run.fragments();
    Cracks cracks;
    for (const BondGeometry& bond : body.bonds) {
        if (fragment[bond.i] == fragment[bond.j]) continue;
        ++cracks.all;
        cracks.at_line += std::abs(bond.centroid.x - kLine) < kHalfWidth + body.spacing;
    }
    return cracks;
}

TEST(Painted, ABarBreaksAtTheDarkLineAndNotWhereItIsHit) {
    const test::TemporaryFolder folder;
    const Cracks painted = cracksOf(barShot(folder.write("painted.obj", barText(true)))),
                 plain = cracksOf(barShot(folder.write("plain.obj", barText(false))));
    EXPECT_GT(painted.at_line, 10u);
    EXPECT_GT(double(painted.at_line), 0.5 * double(painted.all)) << "the others are chips where it is hit";
    EXPECT_EQ(plain.at_line, 0u) << "of " << plain.all;
}

TEST(Painted, AModelWithoutColoursIsRefused) {
    const test::TemporaryFolder folder;
    const Shot shot = barShot(folder.write("bare.obj", barText(false, false)));
    try {
        SceneRun run(shot);
        FAIL() << "it has none";
    } catch (const InputFileError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "Strength is to follow painted colours, and 'bare.obj' has no colours at its vertices; "
                  "export it with them.");
    }
}

}  // namespace
}  // namespace demolish::tests
