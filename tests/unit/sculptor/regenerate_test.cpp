// SPDX-License-Identifier: Apache-2.0
// The recipes make the committed meshes again, byte for byte, on one thread and on many.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "assets/models/sculpt.h"

namespace demolish::sculptor {
namespace {

struct Made {
    const char *recipe, *mesh;
    std::size_t triangles, threads;
};

void PrintTo(const Made& made, std::ostream* out) {
    *out << made.mesh << " on " << made.threads << " threads";
}

class Regenerate : public testing::TestWithParam<Made> {};

TEST_P(Regenerate, GivesTheCommittedBytes) {
    const auto& [recipe, mesh, triangles, threads] = GetParam();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const std::string folder = DEMOLISH_SOURCE_DIR "/assets/models/";
    const std::string text = objText(sculpt(readRecipe(folder + recipe + ".toml"), triangles), recipe);
    std::ifstream in(folder + mesh, std::ios::binary);
    const std::string committed(std::istreambuf_iterator<char>(in), {});
    ASSERT_FALSE(committed.empty());
    EXPECT_EQ(text.size(), committed.size());
    EXPECT_EQ(std::hash<std::string>{}(text), std::hash<std::string>{}(committed));
    EXPECT_TRUE(text == committed);
}

INSTANTIATE_TEST_SUITE_P(
    Models, Regenerate,
    testing::Values(Made{"rabbit", "rabbit_paper.obj", 592, 1}, Made{"rabbit", "rabbit_paper.obj", 592, 7},
                    Made{"rabbit", "rabbit.obj", 20000, 2}, Made{"vase", "vase_paper.obj", 3000, 1},
                    Made{"vase", "vase.obj", 19872, 1}, Made{"column", "column_paper.obj", 674, 1},
                    Made{"column", "column.obj", 20160, 1}, Made{"tumbler", "tumbler.obj", 5920, 1},
                    Made{"dish", "dish.obj", 5568, 1}, Made{"wrecking_ball", "wrecking_ball.obj", 1200, 2},
                    Made{"wolf", "wolf_paper.obj", 18724, 2}, Made{"wolf", "wolf.obj", 60000, 2}));

}  // namespace
}  // namespace demolish::sculptor
