// SPDX-License-Identifier: Apache-2.0
// Files are whole or not there.
#include "app/session/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <thread>
#include <vector>

#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

size_t filesIn(const std::filesystem::path& folder) {
    size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

TEST(OutputFile, ReplacesAndLeavesNoTemporaryFile) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "report.json";
    writeTextFile(file, "first");
    writeTextFile(file, "second");
    EXPECT_EQ(test::readText(file), "second");
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(OutputFile, NamesTheFileThatCouldNotBeWritten) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "missing" / "report.json";
    try {
        writeTextFile(file, "text");
        FAIL() << "no complaint";
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("make its folder first"), std::string::npos);
    }
    folder.write("plain", "a file, not a folder");
    EXPECT_THROW(makeOutputFolder(folder.path() / "plain" / "below"), OutputError);
}

TEST(OutputFile, SaysBeforehandWhetherAFileCanBeWritten) {
    const test::TemporaryFolder folder;
    requireWritable(folder.path() / "report.json");
    EXPECT_EQ(filesIn(folder.path()), 0u) << "nothing is left behind";
    folder.write("there.json", "as it was");
    requireWritable(folder.path() / "there.json");
    EXPECT_EQ(test::readText(folder.path() / "there.json"), "as it was");
    EXPECT_THROW(requireWritable(folder.path() / "missing" / "report.json"), OutputError);
    EXPECT_THROW(requireWritable(folder.path()), OutputError) << "a folder";
}

TEST(OutputFile, MakesFoldersAndLeavesThemEmpty) {
    const test::TemporaryFolder folder;
    makeOutputFolder(folder.path() / "a" / "b");
    EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "a" / "b"));
    EXPECT_EQ(filesIn(folder.path() / "a" / "b"), 0u);
}

TEST(OutputFile, LeavesFilesOfOtherNamesAlone) {
    const test::TemporaryFolder folder;
    const auto neighbour = folder.write("report.json.tmp", "mine");
    requireWritable(folder.path() / "report.json");
    EXPECT_EQ(test::readText(neighbour), "mine");
    writeTextFile(folder.path() / "report.json", "text");
    EXPECT_EQ(test::readText(neighbour), "mine");
    makeOutputFolder(folder.path());
    const auto probe = folder.write(".writable.tmp", "mine, too");
    makeOutputFolder(folder.path());
    EXPECT_EQ(test::readText(probe), "mine, too");
}

TEST(OutputFile, TheNextRunRemovesWhatAKilledOneHasLeft) {
    const test::TemporaryFolder folder;
    folder.write(".demolish.1.0", "half a report");
    requireWritable(folder.path() / "report.json");
    EXPECT_EQ(filesIn(folder.path()), 0u);
    folder.write(".demolish.1.7.mp4", "half a film");
    makeOutputFolder(folder.path());
    EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST(OutputFile, TwoWritersOfOneFileDoNotMeet) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "threshold.json";
    const auto textOf = [](char writer) { return std::string(100'000, writer); };
    writeTextFile(file, textOf('a'));
    std::atomic<int> complaints = 0;
    {
        std::vector<std::jthread> writers;
        for (const char writer : {'a', 'b', 'c', 'd'})
            writers.emplace_back([&, writer] {
                for (int time = 0; time < 50; ++time) try {
                        writeTextFile(file, textOf(writer));
                        const std::string text = test::readText(file);
                        if (text.size() != 100'000 || text != textOf(text[0])) ++complaints;
                    } catch (const OutputError&) {
                        ++complaints;
                    }
            });
    }
    EXPECT_EQ(complaints, 0);
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(OutputFile, TakesTheLongestNameThatThereCanBe) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / std::string(255, 'n');
    writeTextFile(file, "text");
    EXPECT_EQ(test::readText(file), "text");
}

TEST(OutputFile, WritesIntoPipesAndThroughLinks) {
    const test::TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDWR | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    requireWritable(pipe);
    writeTextFile(pipe, "text");
    char read_back[8] = {};
    EXPECT_EQ(read(reader, read_back, sizeof read_back), 4);
    close(reader);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));

    const auto there = folder.write("there.json", "old"), link = folder.path() / "link.json";
    std::filesystem::create_symlink(there, link);
    writeTextFile(link, "new");
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(test::readText(there), "new");
}

TEST(OutputFile, FailsWithoutTraceWhereNothingCanBePut) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "taken" / "full");
    EXPECT_THROW(writeTextFile(folder.path() / "taken", "text"), OutputError) << "a folder";
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

}  // namespace
}  // namespace demolish
