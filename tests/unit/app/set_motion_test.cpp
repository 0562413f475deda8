// SPDX-License-Identifier: Apache-2.0
// Nodes of a set that its animations move: bodies on a path.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/bridge/host_frame.h"
#include "app/session/built_shot.h"
#include "app/session/set_scene.h"
#include "app/session/shot_geometry.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"
#include "tests/unit/meshes/gltf_set.h"

namespace demolish {
namespace {

using testing::HasSubstr;

constexpr float kHalf = 0.70710678f;

/// A block of a metre, and a hammer of 0.4 m beside it.
const char* const kNodes = R"([{"name":"block","mesh":0,"translation":[0,0.5,0]},
{"name":"hammer","mesh":0,"translation":[2,0.7,0],"scale":[0.4,0.4,0.4]}])";

std::string channel(int node, int list, const char* what) {
    const std::string times = std::to_string(list), values = std::to_string(list + 1);
    return R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":)" + std::to_string(node) +
           R"(,"path":")" + what + R"("}}],"samplers":[{"input":)" + times + R"(,"output":)" + values +
           "}]}]";
}

class SetMotion : public testing::Test {
  protected:
    Shot split(const std::string& nodes, const std::string& more,
               const std::vector<test::GltfNumbers>& numbers, const std::string& scene = "[0,1]") {
        Shot shot =
            splitShot(test::writeGltfSet(folder_.path(), "set.gltf", nodes, scene, more, numbers), {});
        shot.device = DeviceChoice::kCpu;
        return shot;
    }
    /// It goes 1.8 m towards the block in a second, and turns by a quarter about z.
    Shot struck() {
        return split(kNodes,
                     R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}},
{"sampler":1,"target":{"node":1,"path":"rotation"}}],
"samplers":[{"input":2,"output":3},{"input":2,"output":4}]}])",
                     {{"SCALAR", {0, 1}},
                      {"VEC3", {2, 0.7f, 0, 0.2f, 0.7f, 0}},
                      {"VEC4", {0, 0, 0, 1, 0, 0, kHalf, kHalf}}});
    }
    test::TemporaryFolder folder_;
};

/// m: where a point is at a time that stands `from_foot` from the body's place at the start.
glm::dvec3 pointAt(const Shot& shot, size_t body, const glm::dvec3& from_foot, double time) {
    const SceneBody& of = shot.bodies.at(body);
    const Double3 start = fromGlm(toGlm(of.position) + turnOf(of) * from_foot / shot.height);
    return shot.height * toGlm(placeOnPath(of.path, of.position, start, time));
}

TEST_F(SetMotion, AnAnimatedNodeIsABodyOnAPathThatDoesNotBreak) {
    const Shot shot = struck();
    ASSERT_EQ(shot.bodies.size(), 2u);
    EXPECT_TRUE(shot.bodies[0].breaks && shot.bodies[0].path.keys.empty());
    EXPECT_FALSE(shot.bodies[1].breaks);
    EXPECT_LT(shot.bodies[1].path.keys.size(), 40u) << "as few as tell it";
    for (const double time : {0.0, 0.31, 0.5, 0.9, 1.0, 5.0}) {
        const double t = std::min(time, 1.0), angle = t * M_PI / 2;
        const glm::dvec3 middle(2 - 1.8 * t, 0.7, 0);
        EXPECT_LT(glm::distance(pointAt(shot, 1, {0, 0.2, 0}, time), middle), 0.004) << time;
        const glm::dvec3 side = middle + 0.2 * glm::dvec3(std::cos(angle), std::sin(angle), 0);
        EXPECT_LT(glm::distance(pointAt(shot, 1, {0.2, 0.2, 0}, time), side), 0.004) << time;
    }
    EXPECT_EQ(shot.impact.velocity, 0) << "it takes the ball's place";
    EXPECT_EQ(shot.impact.body, 0u);
}

TEST_F(SetMotion, AHammerOfAFileBreaksWhatItHits) {
    Shot shot = struck();
    shot.fineness.particles = 60;
    shot.material.critical_velocity = 0.05;
    const BuiltShot built = buildShot(shot, {.draw_geometry = false}, {});
    const size_t of_block = built.setup.bodies[0].body->particles.size();
    for (int frame = 0; frame < 72; ++frame) ASSERT_EQ(built.solver->advanceFrame(), StepStatus::kOk);
    EXPECT_GT(built.solver->stats().bonds_broken, 0u);
    const auto frame = readFrame(*built.solver, FrameParts::kParticles | FrameParts::kFragments);
    glm::dvec3 sum(0);
    const size_t end = of_block + built.setup.bodies[1].body->particles.size();
    for (size_t i = of_block; i < end; ++i) {
        const Float3& p = frame.particles[i].position;
        sum += glm::dvec3(p.x, p.y, p.z);
        EXPECT_EQ(frame.particle_fragment[i], frame.particle_fragment[of_block]) << "it is whole";
    }
    EXPECT_LT(glm::distance(sum / double(end - of_block), glm::dvec3(0.2, 0.7, 0)), 0.03);
}

/// Angles are told one by one: beyond half a turn, and where the middle one is beyond a quarter.
TEST_F(SetMotion, WholeTurnsAreTurned) {
    std::vector<float> times, turns;
    for (int k = 0; k <= 6; ++k) {
        times.push_back(0.5f * static_cast<float>(k));
        const float half = static_cast<float>(k * M_PI / 3);  // of 120 degrees each
        turns.insert(turns.end(), {0, std::sin(half), 0, std::cos(half)});
    }
    const Shot shot = split(kNodes, channel(1, 2, "rotation"), {{"SCALAR", times}, {"VEC4", turns}});
    for (double time = 0; time <= 3; time += 0.11) {
        const double angle = time / 0.5 * 2 * M_PI / 3;
        const glm::dvec3 side(2 + 0.2 * std::cos(angle), 0.7, -0.2 * std::sin(angle));
        EXPECT_LT(glm::distance(pointAt(shot, 1, {0.2, 0.2, 0}, time), side), 0.002) << time;
    }
    EXPECT_NEAR(shot.bodies[1].path.keys.back().turn.y, 4 * M_PI, 1e-3);
}

TEST_F(SetMotion, AnAnimationThatOnlyPutsItElsewherePutsItThere) {
    const Shot shot =
        split(kNodes, channel(1, 2, "translation"), {{"SCALAR", {0, 1}}, {"VEC3", {3, 0.9f, 1, 3, 0.9f, 1}}});
    EXPECT_TRUE(shot.bodies[1].breaks && shot.bodies[1].path.keys.empty());
    EXPECT_LT(glm::distance(shot.height * toGlm(shot.bodies[1].position), glm::dvec3(3, 0.7, 1)), 1e-5);
    EXPECT_TRUE(shot.impact.times_threshold) << "and a ball hits, as in sets where nothing moves";
}

TEST_F(SetMotion, WhereAllWouldMoveNothingDoes) {
    const Shot shot = split(R"([{"name":"alone","mesh":0}])", channel(0, 2, "translation"),
                            {{"SCALAR", {0, 1}}, {"VEC3", {0, 0, 0, 2, 0, 0}}}, "[0]");
    EXPECT_TRUE(shot.bodies[0].breaks && shot.bodies[0].path.keys.empty());
    EXPECT_TRUE(shot.impact.times_threshold);
}

TEST_F(SetMotion, MoreThanAScenesPathsAreRefused) {
    std::string nodes = R"([{"name":"block","mesh":0},{"name":"group","children":[2)", things,
                roots = "[0,1]";
    for (int i = 0; i < 17; ++i) {
        if (i > 0) nodes.append(",").append(std::to_string(i + 2));
        things.append(R"(,{"name":"n)").append(std::to_string(i)).append(R"(","mesh":0})");
    }
    try {
        split(nodes + "]}" + things + "]", channel(1, 2, "translation"),
              {{"SCALAR", {0, 1}}, {"VEC3", {0, 0, 0, 2, 0, 0}}}, roots);
        FAIL() << "no complaint";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("17 nodes that its animations move; at most 16"));
    }
}

}  // namespace
}  // namespace demolish
