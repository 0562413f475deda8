// SPDX-License-Identifier: Apache-2.0
// What lights a shot, by name, by file, by hour; and what options refuse.
#include "app/session/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "app/session/shot.h"
#include "engine/surroundings/surroundings.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/run_program.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

TEST(Environment, HasNamesOfItsOwnAndFiles) {
    Environment environment;
    for (const std::string& name : ownEnvironmentNames()) {
        setEnvironment(environment, name);
        EXPECT_EQ(environmentName(environment), name);
    }
    setEnvironment(environment, "/a/place/Dawn.HDR");
    EXPECT_EQ(environment.kind, engine::SurroundingsKind::kFile);
    EXPECT_EQ(environmentName(environment), "Dawn.HDR");
    EXPECT_THROW(setEnvironment(environment, "dusk"), UsageError);
    EXPECT_THROW(setEnvironment(environment, "dusk.jpg"), UsageError);
}

TEST(Environment, TheSunRisesStandsHighestAtNoonAndSets) {
    const glm::vec3 light(0.5f, -0.7f, -0.5f);
    const glm::vec3 noon = sunAtHour(12, light);
    EXPECT_NEAR(noon.y, std::sin(std::numbers::pi / 3), 1e-5);  // 90 - 45 + 15 degrees
    EXPECT_NEAR(glm::dot(glm::normalize(glm::vec2(noon.x, noon.z)), glm::normalize(glm::vec2(-0.5f, 0.5f))),
                1, 1e-5);
    float last = -1;
    for (double hour = kHourRange.least; hour <= 12; hour += 0.5) {
        const glm::vec3 morning = sunAtHour(hour, light), evening = sunAtHour(24 - hour, light);
        EXPECT_NEAR(morning.y, evening.y, 1e-5);
        EXPECT_GT(morning.y, last);
        EXPECT_NEAR(glm::length(morning), 1, 1e-5);
        last = morning.y;
    }
    EXPECT_LT(std::abs(sunAtHour(kHourRange.least, light).y), 0.03f);
}

TEST(Environment, OwnSurroundingsFollowTheScenesSun) {
    engine::Lighting lighting;
    const engine::Lighting lit = litBy({}, lighting);
    ASSERT_TRUE(lit.surroundings);
    EXPECT_GT(glm::dot(glm::normalize(lit.sun_direction), glm::normalize(lighting.sun_direction)), 0.9999f);
    EXPECT_GT(lit.sun_colour.x, lit.sun_colour.z) << "air takes blue from the sun";
    EXPECT_EQ(litBy({}, lighting).surroundings, lit.surroundings) << "made once";
    Environment red;
    red.sun_colour = glm::vec3(2, 0, 0);
    EXPECT_EQ(litBy(red, lighting).sun_colour, glm::vec3(2, 0, 0));
}

class EnvironmentFiles : public testing::Test {
  protected:
    /// Which sentence the program says, and its exit code.
    test::ProgramRun capture(std::vector<std::string> options) {
        std::vector<std::string> words = {
            "capture", "block",      "--particles", "12",    "--frames",
            "1",       "--substeps", "10",          "--out", (folder_.path() / "out").string(),
            "--size",  "64x36",      "--device",    "cpu"};
        words.insert(words.end(), options.begin(), options.end());
        return test::runProgram(words);
    }
    test::TemporaryFolder folder_;
};

TEST_F(EnvironmentFiles, ABadOneIsOneSentenceAndExitThree) {
    const std::string file = (folder_.path() / "bad.hdr").string();
    std::ofstream(file) << "#?RADIANCE\nno more";
    const test::ProgramRun run = capture({"--environment", file});
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.err.find("bad.hdr is damaged"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("making cells"), std::string::npos) << "told before a body is made";
    EXPECT_EQ(capture({"--environment", (folder_.path() / "none.exr").string()}).exit_code, 3);
}

TEST_F(EnvironmentFiles, OddOptionsAreRefused) {
    using Words = std::vector<std::string>;
    for (const Words& words :
         {Words{"--environment", "dusk"}, Words{"--hour", "3"}, Words{"--hour", "nan"},
          Words{"--hour", "9", "--environment", "studio"}, Words{"--environment-turn", "20"},
          Words{"--white-balance", "0"}, Words{"--exposure", "-1"}, Words{"--tone", "acid"},
          Words{"--floor", "lava"}, Words{"--shutter", "2"}, Words{"--samples", "0"},
          Words{"--samples", "1.5"}, Words{"--aperture", "0"}, Words{"--focus", "0"}, Words{"--look", "best"},
          Words{"--transparent", "--video", "a.mp4"}}) {
        const test::ProgramRun run = capture(words);
        EXPECT_EQ(run.exit_code, 2) << words[0] << ' ' << words.back() << ": " << run.err;
    }
}

}  // namespace
}  // namespace demolish
