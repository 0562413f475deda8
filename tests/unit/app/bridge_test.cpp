// SPDX-License-Identifier: Apache-2.0
// The bridges' arithmetic: stream layouts, how much of the draw lists is in use, device ordinals.
#include <gtest/gtest.h>

#include "app/bridge/frame_bridge.h"
#include "app/bridge/host_bridge.h"
#include "app/bridge/stream_layout.h"

namespace demolish {
namespace {

TEST(Bridge, StreamsCountElementsOfTheirOwnSize) {
    std::array<std::byte, 512 * kStreamCount> memory{};
    std::array<void*, kStreamCount> data{};
    std::array<size_t, kStreamCount> bytes{};
    for (size_t i = 0; i < kStreamCount; ++i) {
        data[i] = memory.data() + 512 * i;
        bytes[i] = 10 * kStreamElementBytes[i];
    }
    const RenderStreams streams = streamsAt(data, bytes, ParticleColour::kStress);
    EXPECT_EQ(streams.particles.capacity, 10u);
    EXPECT_EQ(streams.transforms.capacity, 10u);
    EXPECT_EQ(streams.interior_vertices.capacity, 10u);
    EXPECT_EQ(streams.commands.capacity, 10u);
    EXPECT_EQ(static_cast<void*>(streams.crack_edges.data),
              data[static_cast<size_t>(engine::StreamId::kCrackEdges)]);
    EXPECT_EQ(streams.colour, ParticleColour::kStress);
}

TEST(Bridge, UseOfTheDrawListsFollowsFromCountsAndHighestIndex) {
    DrawCommands commands{};
    const std::vector<uint32_t> indices = {0, 4, 2, 9, 1, 3};
    EXPECT_EQ(drawListUse(commands, indices).interior_vertices, 0u);
    commands.interior.count = 3;
    commands.cracks.instance_count = 5;
    DrawListUse use = drawListUse(commands, indices);
    EXPECT_EQ(use.interior_indices, 3u);
    EXPECT_EQ(use.interior_vertices, 5u);
    EXPECT_EQ(motionElements(engine::StreamId::kCrackEdges, 7, commands), 5u);
    EXPECT_EQ(motionElements(engine::StreamId::kTransforms, 7, commands), 7u);
    commands.interior.count = 100;  // never beyond what is there
    use = drawListUse(commands, indices);
    EXPECT_EQ(use.interior_indices, 6u);
    EXPECT_EQ(use.interior_vertices, 10u);
}

/// All asleep, `frame` frames on.
FrameStats asleep(uint64_t frame) {
    FrameStats stats;
    stats.frame = frame;
    stats.fragments = stats.sleeping_fragments = 3;
    return stats;
}

TEST(Bridge, WhatSleepsTravelsOnceMoreAndThenOnlyProjectiles) {
    ExportHistory history;
    const auto colour = ParticleColour::kFragment;
    FrameStats moving = asleep(1);
    moving.awake_particles = 40;
    EXPECT_EQ(history.next(asleep(0), colour, true), FrameChange::kAll);
    EXPECT_EQ(history.next(moving, colour, false), FrameChange::kMotion);
    EXPECT_EQ(history.next(asleep(2), colour, false), FrameChange::kMotion);
    EXPECT_EQ(history.next(asleep(3), colour, false), FrameChange::kProjectiles);
    EXPECT_EQ(history.next(asleep(3), colour, false), FrameChange::kProjectiles);
    moving.frame = 4;
    EXPECT_EQ(history.next(moving, colour, false), FrameChange::kMotion);
}

TEST(Bridge, WhatAPathLeadsTravelsWhileAllElseSleeps) {
    ExportHistory history;
    const auto colour = ParticleColour::kFragment;
    history.next(asleep(0), colour, true);
    for (const uint64_t frame : {1, 2, 3}) {
        FrameStats led = asleep(frame);
        led.rigid_fragments = 1;
        EXPECT_EQ(history.next(led, colour, false), FrameChange::kMotion) << frame;
    }
}

TEST(Bridge, WhatBreaksOrIsFreshTravelsWhole) {
    ExportHistory history;
    const auto colour = ParticleColour::kFragment;
    history.next(asleep(0), colour, true);
    FrameStats broken = asleep(1);
    broken.bonds_broken = 1;
    EXPECT_EQ(history.next(broken, colour, false), FrameChange::kAll);
    broken.frame = 2;
    EXPECT_EQ(history.next(broken, colour, false), FrameChange::kProjectiles);
    EXPECT_EQ(history.next(broken, colour, true), FrameChange::kAll);
    EXPECT_EQ(history.next(asleep(0), colour, false), FrameChange::kAll) << "a restart heals bonds";
}

TEST(Bridge, ColoursAndFramesThatWereSkippedAreBroughtOver) {
    ExportHistory history;
    history.next(asleep(0), ParticleColour::kFragment, true);
    EXPECT_EQ(history.next(asleep(1), ParticleColour::kStress, false), FrameChange::kMotion);
    EXPECT_EQ(history.next(asleep(3), ParticleColour::kStress, false), FrameChange::kMotion);
    EXPECT_EQ(history.next(asleep(4), ParticleColour::kStress, false), FrameChange::kProjectiles);
}

TEST(Bridge, ASolverThatPutsNothingToSleepAlwaysTravels) {
    ExportHistory history;
    FrameStats stats;
    stats.fragments = 1;
    history.next(stats, ParticleColour::kFragment, true);
    for (stats.frame = 1; stats.frame < 4; ++stats.frame)
        EXPECT_EQ(history.next(stats, ParticleColour::kFragment, false), FrameChange::kMotion);
}

TEST(Bridge, VisibleDevicesRenumberCudaOnly) {
    EXPECT_EQ(eglOrdinal(0, nullptr), 0);
    EXPECT_EQ(eglOrdinal(1, nullptr), 1);
    EXPECT_EQ(eglOrdinal(0, "2,3"), 2);
    EXPECT_EQ(eglOrdinal(1, "2,3"), 3);
    EXPECT_EQ(eglOrdinal(2, "2,3"), 2);  // beyond the list: as it was
    EXPECT_EQ(eglOrdinal(0, "GPU-5f1c"), 0);
}

}  // namespace
}  // namespace demolish
