// SPDX-License-Identifier: Apache-2.0
// Files are whole or not there.
#include "app/session/output_file.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace demolish
