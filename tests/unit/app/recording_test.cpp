// SPDX-License-Identifier: Apache-2.0
// A recorded frame shows what it showed when it was new, in every colour of the particle view. On the CPU,
// and through interop, or the way that DEMOLISH_TRANSFER names, when the same program is run with
// DEMOLISH_TEST_DEVICE=cuda (CTest label gpu).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <vector>

#include "app/bridge/frame_bridge.h"
#include "app/session/scene_file.h"
#include "app/session/session.h"
#include "engine/platform/headless_context.h"
#include "engine/render/fracture_mesh.h"

namespace demolish {
namespace {

constexpr std::array kChannels = {ParticleColour::kFragment, ParticleColour::kDamage, ParticleColour::kStress,
                                  ParticleColour::kSpeed};
constexpr size_t kFrames = 8;

/// Spheres of the particle view in all colours.
using Seen = std::array<std::vector<ParticleInstance>, kChannels.size()>;

std::vector<ParticleInstance> instances(const Session& session) {
    std::vector<ParticleInstance> all(session.mesh()->particleCount());
    session.mesh()->stream(engine::StreamId::kParticles).download(std::as_writable_bytes(std::span(all)));
    return all;
}

std::vector<CrackLine> crackLines(const Session& session) {
    DrawCommands commands{};
    session.mesh()
        ->stream(engine::StreamId::kCommands)
        .download(std::as_writable_bytes(std::span(&commands, 1)));
    std::vector<CrackLine> lines(commands.cracks.instance_count);
    if (!lines.empty())
        session.mesh()
            ->stream(engine::StreamId::kCrackEdges)
            .download(std::as_writable_bytes(std::span(lines)));
    return lines;
}

Seen look(Session& session) {
    Seen seen;
    for (size_t c = 0; c < kChannels.size(); ++c) {
        session.setColour(kChannels[c]);
        seen[c] = instances(session);
    }
    return seen;
}

float highest(const std::vector<ParticleInstance>& all) {
    float value = 0;
    for (const ParticleInstance& instance : all) value = std::max(value, instance.value);
    return value;
}

bool asksForGpu() {
    const char* device = std::getenv("DEMOLISH_TEST_DEVICE");
    return device != nullptr && std::string_view(device) == "cuda";
}

class RecordingTest : public testing::Test {
  protected:
    void SetUp() override {
        const CudaDevice device = findCudaDevice();
        if (asksForGpu() && !device.usable) GTEST_SKIP() << device.problem;
        engine::HeadlessOptions options;
        options.software_only = !asksForGpu();
        if (asksForGpu())
            options.cuda_device = eglOrdinal(device.ordinal, std::getenv("CUDA_VISIBLE_DEVICES"));
        context_.emplace(options);
        session_.emplace(buildShot(blockHitSoon(), {}, {}), SessionOptions{.draw = true, .record = true});
        const char* way = std::getenv("DEMOLISH_TRANSFER");
        EXPECT_STREQ(session_->transfer(), !asksForGpu() ? "host" : way != nullptr ? way : "interop");
    }
    static Shot blockHitSoon() {
        Shot shot = loadScene("block");
        shot.device = asksForGpu() ? DeviceChoice::kCuda : DeviceChoice::kCpu;
        shot.fineness.particles = 150;
        shot.impact.arrival_time = 0.03;
        return shot;
    }
    std::optional<engine::HeadlessContext> context_;
    std::optional<Session> session_;
};

TEST_F(RecordingTest, KeepsEveryColourOfEveryFrame) {
    std::vector<Seen> live{look(*session_)};
    for (size_t frame = 1; frame < kFrames; ++frame) {
        session_->setColour(kChannels[frame % kChannels.size()]);  // whichever is shown while it is recorded
        ASSERT_EQ(session_->advance(), StepStatus::kOk);
        live.push_back(look(*session_));
    }
    ASSERT_GT(session_->status().stats.bonds_broken, 0u);
    for (size_t c = 1; c < kChannels.size(); ++c) EXPECT_GT(highest(live[kFrames - 2][c]), 0.02f);
    for (size_t frame = 0; frame + 1 < kFrames; ++frame) {
        session_->apply(command::Scrub{frame}, 0);
        ASSERT_TRUE(session_->status().replaying);
        const Seen replayed = look(*session_);
        for (size_t c = 0; c < kChannels.size(); ++c)
            for (size_t i = 0; i < live[frame][c].size(); ++i) {
                ASSERT_EQ(replayed[c][i].fragment, live[frame][c][i].fragment);
                if (kChannels[c] == ParticleColour::kFragment) continue;  // drawn by the slot
                ASSERT_NEAR(replayed[c][i].value, live[frame][c][i].value, 0.51f / 255)
                    << "frame " << frame << " channel " << c << " particle " << i;
            }
    }
}

/// Cracks open and close while no bond breaks, and a recording knows how far.
TEST_F(RecordingTest, KeepsHowFarCracksHaveOpened) {
    std::vector<std::vector<CrackLine>> live{crackLines(*session_)};
    size_t opened = 0;  // frames in which widths alone have changed
    for (size_t frame = 1; frame < 4 * kFrames; ++frame) {
        const uint32_t broken = session_->status().stats.bonds_broken;
        ASSERT_EQ(session_->advance(), StepStatus::kOk);
        live.push_back(crackLines(*session_));
        opened += session_->status().stats.bonds_broken == broken && live[frame] != live[frame - 1];
    }
    EXPECT_GT(opened, 0u);
    for (size_t frame = 0; frame + 1 < live.size(); ++frame) {
        session_->apply(command::Scrub{frame}, 0);
        EXPECT_EQ(crackLines(*session_), live[frame]) << "frame " << frame;
    }
}

std::vector<float> numbersOf(const std::vector<engine::SphereDraw>& spheres) {
    std::vector<float> numbers;
    for (const engine::SphereDraw& sphere : spheres) {
        numbers.insert(numbers.end(), std::begin(sphere.position), std::end(sphere.position));
        numbers.push_back(sphere.radius);
    }
    return numbers;
}

/// What one sees of a frame: its number, its spheres, its balls.
struct Sight {
    uint64_t frame = 0;
    Seen pieces;
    std::vector<float> balls;
};

Sight sightOf(Session& session) {
    return {session.status().stats.frame, look(session), numbersOf(session.spheres())};
}

void expectSame(const Sight& seen, const Sight& then) {
    EXPECT_EQ(seen.frame, then.frame);
    EXPECT_EQ(seen.balls, then.balls);
    for (size_t c = 0; c < kChannels.size(); ++c)
        for (size_t i = 0; i < then.pieces[c].size(); ++i) {
            const ParticleInstance &now = seen.pieces[c][i], &before = then.pieces[c][i];
            ASSERT_EQ(now.fragment, before.fragment) << "particle " << i;
            ASSERT_EQ(now.position.x, before.position.x) << "particle " << i;
            ASSERT_EQ(now.position.y, before.position.y) << "particle " << i;
        }
}

TEST_F(RecordingTest, AFullOneShowsItsLastFrameAsItWasAndThenTheNewest) {
    constexpr size_t kRecorded = 3;
    for (size_t frame = 0; frame < kRecorded; ++frame) ASSERT_EQ(session_->advance(), StepStatus::kOk);
    const SessionOptions until_here{
        .draw = true, .record = true, .memory_limit = session_->status().recorded_bytes};
    ASSERT_EQ(session_->advance(), StepStatus::kOk);
    session_->apply(command::Scrub{kRecorded}, 0);
    const Sight last_recorded = sightOf(*session_);

    Session full(buildShot(blockHitSoon(), {}, {}), until_here);
    for (size_t frame = 0; frame < kRecorded + 5; ++frame) ASSERT_EQ(full.advance(), StepStatus::kOk);
    ASSERT_EQ(full.status().recorded_frames, kRecorded + 1);
    EXPECT_FALSE(full.status().replaying);
    const Sight newest = sightOf(full);
    ASSERT_NE(newest.balls, last_recorded.balls);

    full.apply(command::Scrub{kRecorded}, 0);
    EXPECT_TRUE(full.status().replaying);
    expectSame(sightOf(full), last_recorded);
    full.apply(command::Step{}, 0);
    EXPECT_FALSE(full.status().replaying);
    expectSame(sightOf(full), newest);
    full.apply(command::Step{}, 0);
    EXPECT_EQ(full.status().stats.frame, newest.frame + 1);
}

TEST_F(RecordingTest, ColoursOfAFrameTakeTwoBytesAParticle) {
    const auto bytes = [&] { return session_->status().recorded_bytes; };
    const size_t before = bytes();
    ASSERT_EQ(session_->advance(), StepStatus::kOk);
    ASSERT_EQ(session_->status().stats.bonds_broken, 0u) << "or the draw lists and the damage come on top";
    const size_t projectiles = session_->spheres().size() * sizeof(ParticleInstance);
    EXPECT_EQ(bytes() - before, sizeof(RecordedFrame) + sizeof(FragmentTransform) + projectiles +
                                    2 * session_->mesh()->particleCount());
}

}  // namespace
}  // namespace demolish
