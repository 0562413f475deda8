// SPDX-License-Identifier: Apache-2.0
// Builds beside the caller: what comes of them, and of those that nobody wants any more.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "app/reading/model_reader.h"
#include "app/session/rebuild_worker.h"
#include "app/session/scene_file.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

Shot blockOf(uint32_t particles) {
    Shot shot = loadScene("block");
    shot.device = DeviceChoice::kCpu;
    shot.fineness.particles = particles;
    return shot;
}

std::optional<BuiltShot> waitFor(RebuildWorker& worker) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (worker.busy()) {
        if (std::chrono::steady_clock::now() > patience) throw std::runtime_error("the build does not end");
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return worker.take();
}

TEST(RebuildWorker, BuildsAndReusesTheMesh) {
    const BuiltShot present = buildShot(blockOf(60), {}, {});
    RebuildWorker worker;
    EXPECT_FALSE(worker.busy());
    EXPECT_FALSE(worker.take());
    worker.start(blockOf(90), present);
    const auto built = waitFor(worker);
    ASSERT_TRUE(built);
    EXPECT_EQ(built->body->particles.size(), 90u);
    EXPECT_EQ(built->cells.subject_mesh, present.cells.subject_mesh);
    EXPECT_FALSE(worker.take()) << "handed over once";
    EXPECT_NE(worker.progress().stage, "");
}

TEST(RebuildWorker, CancelledBuildGivesNothingAndTheNextOneIsNotDisturbed) {
    const BuiltShot present = buildShot(blockOf(60), {}, {});
    RebuildWorker worker;
    for (uint32_t k = 0; k < 5; ++k) {
        worker.start(blockOf(3000 + k), present);
        EXPECT_TRUE(worker.busy());
        worker.cancel();
        EXPECT_FALSE(worker.busy());
        EXPECT_FALSE(worker.take());
        EXPECT_EQ(worker.progress().stage, "");
    }
    worker.start(blockOf(4000), present);
    worker.start(blockOf(80), present);  // the latest wish wins
    const auto built = waitFor(worker);
    ASSERT_TRUE(built);
    EXPECT_EQ(built->body->particles.size(), 80u);
}

/// A finished build holds a solver, gigabytes of GPU memory perhaps; nobody can take it any more.
TEST(RebuildWorker, CancelLetsGoOfAFinishedBuild) {
    const BuiltShot present = buildShot(blockOf(60), {}, {});
    const auto holders = present.cells.subject_mesh.use_count();
    RebuildWorker worker;
    worker.start(blockOf(90), present);
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    const auto waitWhile = [&](const auto& condition) {
        while (condition() && std::chrono::steady_clock::now() < patience)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
    };
    waitWhile([&] { return worker.busy(); });
    worker.cancel();
    waitWhile([&] { return present.cells.subject_mesh.use_count() > holders; });
    EXPECT_EQ(present.cells.subject_mesh.use_count(), holders) << "the build shares its mesh";
    EXPECT_FALSE(worker.take());
}

TEST(RebuildWorker, ErrorsArriveWhereTheResultIsTaken) {
    const BuiltShot present = buildShot(blockOf(60), {}, {});
    RebuildWorker worker;
    Shot shot = blockOf(60);
    shot.model = "nowhere.obj";
    worker.start(shot, present);
    EXPECT_THROW(waitFor(worker), InputFileError);
    EXPECT_FALSE(worker.take()) << "told once";
    worker.start(blockOf(70), present);
    EXPECT_TRUE(waitFor(worker));
}

TEST(RebuildWorker, CancelEndsWhoeverReadsTheModel) {
    const BuiltShot present = buildShot(blockOf(60), {}, {});
    const test::TemporaryFolder folder;
    const auto note = folder.path() / "process",
               reader = folder.write("reader.sh", "#!/bin/sh\necho $$ > '" + note.string() + ".tmp'; mv '" +
                                                      note.string() + ".tmp' '" + note.string() +
                                                      "'; exec sleep 1000\n");
    std::filesystem::permissions(reader, std::filesystem::perms::owner_all);
    setModelReader(reader);
    Shot shot = blockOf(60);
    shot.model = "endless.obj";
    RebuildWorker worker;
    worker.start(shot, present);
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    const auto waitUntil = [&](const auto& reached) {
        while (!reached() && std::chrono::steady_clock::now() < patience)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        return reached();
    };
    ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(note); }));
    worker.cancel();
    const pid_t process = std::stoi(test::readText(note));
    EXPECT_TRUE(waitUntil([&] { return kill(process, 0) != 0; })) << "it still runs";
    setModelReader("");
}

}  // namespace
}  // namespace demolish
