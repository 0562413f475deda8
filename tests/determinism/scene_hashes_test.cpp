// SPDX-License-Identifier: Apache-2.0
// The scenes that people see give the stored bits: all of their bodies at few particles, their balls brought
// forward, stepped as the program steps them (balls between frames, hand-over and sleep), and by the methods
// that ours is compared with; cores is ours on the CPU. Twice: on the CPU,
// by one thread and by two; and with label gpu on the GPU, against the same numbers.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdlib>

#include "tests/determinism/stored_hashes.h"
#include "tests/physics/scenes/scene_run.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

constexpr uint32_t kFrames = 80, kFramesAHash = 20;

struct HashedScene {
    const char* name;
    uint32_t particles;     ///< of each body
    uint32_t least_broken;  ///< bonds, at the end
    Method method = Method::kOurs;
};

/// The scene's name, with the method's where that is not ours.
std::string keyOf(const HashedScene& scene) {
    std::string key = scene.name;
    if (scene.method != Method::kOurs) key += std::string("_") + methodName(scene.method);
    std::replace(key.begin(), key.end(), '-', '_');
    return key;
}

void PrintTo(const HashedScene& scene, std::ostream* out) {
    *out << keyOf(scene);
}

/// What a run went through, so that the hashes are known to speak of breaking, of hand-over and of sleep.
struct HashedRun {
    std::vector<std::string> hashes;  ///< every kFramesAHash frames
    uint32_t broken = 0, most_rigid = 0, most_asleep = 0;
};

HashedRun runOf(const HashedScene& scene) {
    Shot shot = smallScene(scene.name, scene.particles);
    shot.method = scene.method;
    bringForward(shot, {.first = 0.1, .last = 0.3});
    shot.device = asksForGpu() ? DeviceChoice::kCuda : DeviceChoice::kCpu;
    SceneRun run(shot);
    HashedRun hashed;
    for (uint32_t frame = 1; frame <= kFrames; ++frame) {
        run.runTo(frame / shot.fps);
        hashed.most_rigid = std::max(hashed.most_rigid, run.stats().rigid_fragments);
        hashed.most_asleep = std::max(hashed.most_asleep, run.stats().sleeping_fragments);
        if (frame % kFramesAHash == 0) hashed.hashes.push_back(asHex(run.stateHash()));
    }
    hashed.broken = run.stats().bonds_broken;
    return hashed;
}

class SceneHashes : public OnEitherDevice, public testing::WithParamInterface<HashedScene> {};

TEST_P(SceneHashes, AreTheStoredOnes) {
    const HashedScene& scene = GetParam();
    const std::vector<size_t> thread_counts =
        asksForGpu() ? std::vector<size_t>{2} : std::vector<size_t>{1, 2};
    for (const size_t threads : thread_counts) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const HashedRun run = runOf(scene);
        EXPECT_GE(run.broken, scene.least_broken);
        EXPECT_EQ(run.most_rigid > 0, traitsOf(scene.method).may_rest);
        EXPECT_EQ(run.most_asleep > 0, traitsOf(scene.method).may_rest);
        if (std::getenv("DEMOLISH_UPDATE_HASHES") != nullptr && !asksForGpu() && threads == 1)
            storeHashes(keyOf(scene), run.hashes);
        EXPECT_EQ(run.hashes, storedHashes(keyOf(scene))) << threads << " threads";
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneHashes,
                         testing::Values(HashedScene{"bunny", 400, 100}, HashedScene{"wolf", 500, 100},
                                         HashedScene{"vase", 60, 100}, HashedScene{"column", 60, 100},
                                         HashedScene{"arch", 60, 20}, HashedScene{"wall", 4, 20},
                                         HashedScene{"table", 60, 20}, HashedScene{"room", 500, 100}),
                         [](const auto& test) { return keyOf(test.param); });
INSTANTIATE_TEST_SUITE_P(Methods, SceneHashes,
                         testing::Values(HashedScene{"bunny", 150, 50, Method::kHeavy},
                                         HashedScene{"bunny", 400, 100, Method::kPattern},
                                         HashedScene{"bunny", 400, 100, Method::kPatternAtImpact},
                                         HashedScene{"vase", 60, 50, Method::kPattern},
                                         HashedScene{"vase", 60, 50, Method::kPatternAtImpact}),
                         [](const auto& test) { return keyOf(test.param); });

}  // namespace
}  // namespace demolish::tests
