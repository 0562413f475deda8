// SPDX-License-Identifier: Apache-2.0
// What a killed run leaves goes; what others make or own stays.
#include "engine/image/unfinished_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace demolish::engine {
namespace {

namespace fs = std::filesystem;

class UnfinishedFiles : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "unfinished.XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }
    size_t files() const {
        size_t count = 0;
        for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++count;
        return count;
    }
    void write(const std::string& name) const { std::ofstream(folder_ / name) << name; }
    /// A process of our own begins a file and is killed.
    void abandon(const std::string& ending) const {
        const pid_t child = fork();
        if (child == 0) {
            const UnfinishedFile file(folder_, ending);
            kill(getpid(), SIGKILL);
        }
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status));
    }
    fs::path folder_;
};

TEST_F(UnfinishedFiles, OfKilledRunsAreRemoved) {
    abandon("");
    abandon(".mp4");
    ASSERT_EQ(files(), 2u);
    removeAbandonedFiles(folder_);
    EXPECT_EQ(files(), 0u);
}

TEST_F(UnfinishedFiles, InTheMakingStay) {
    UnfinishedFile film(folder_, ".mp4"), text(folder_);
    text.close();  // written, not yet moved
    removeAbandonedFiles(folder_);
    EXPECT_EQ(files(), 2u);
    text.moveTo(folder_ / "text.json");
    film.moveTo(folder_ / "film.mp4");
    removeAbandonedFiles(folder_);
    EXPECT_EQ(files(), 2u);
}

TEST_F(UnfinishedFiles, OfAUserAreNeverTouched) {
    for (const char* name :
         {".demolish", ".demolish.toml", ".demolish.12", ".demolish.12.", ".demolish.x.1", ".demolish.1.x",
          "a.demolish.1.2", ".demolish.1.2x", "film.unfinished.mp4", "a.png.12.part"})
        write(name);
    fs::create_directory(folder_ / ".demolish.1.2");
    fs::create_symlink(folder_ / ".demolish", folder_ / ".demolish.1.3");
    removeAbandonedFiles(folder_);
    EXPECT_EQ(files(), 12u);
    removeAbandonedFiles(folder_ / "missing");
}

TEST_F(UnfinishedFiles, AreGoneWhenNothingBecomesOfThem) {
    { const UnfinishedFile file(folder_); }
    EXPECT_EQ(files(), 0u);
    EXPECT_THROW(UnfinishedFile(folder_ / "missing"), std::system_error);
    fs::create_directories(folder_ / "taken" / "full");
    UnfinishedFile file(folder_);
    EXPECT_THROW(file.moveTo(folder_ / "taken"), std::system_error);
}

}  // namespace
}  // namespace demolish::engine
