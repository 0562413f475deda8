// SPDX-License-Identifier: Apache-2.0
// Every format of the list is an option of its own, which the page of the command line names, and is written
// when asked for.
#include "app/commands/run_formats.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>

#include "app/commands/run_files.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

const char* optionOf(const RunFormat& format, RunCommand command) {
    return command == RunCommand::kCapture ? format.capture_option : format.bench_option;
}

TEST(RunFormats, AreOptionsThatThePageOfTheCommandLineNames) {
    const std::string page =
        test::readText(std::filesystem::path(DEMOLISH_SOURCE_DIR) / "docs" / "command_line.md");
    for (const RunCommand command : {RunCommand::kCapture, RunCommand::kBench}) {
        CLI::App app;
        RunFiles files{command};
        addRunFileOptions(app, files);  // refuses a name that is taken
        size_t offered = 0;
        for (const RunFormat& format : kRunFormats) {
            const char* option = optionOf(format, command);
            if (option == nullptr) continue;
            ++offered;
            EXPECT_THAT(page, testing::HasSubstr(std::string("`") + option + " FILE"));
            EXPECT_NE(app.get_option_no_throw(option), nullptr);
        }
        EXPECT_EQ(files.paths.size(), offered);
        EXPECT_FALSE(files.any());
    }
}

TEST(RunFormats, WhatIsAskedForIsKnownByItsOption) {
    CLI::App app;
    RunFiles files{RunCommand::kBench};
    addRunFileOptions(app, files);
    app.parse("--frame-csv frames.csv");
    EXPECT_EQ(files.at("--frame-csv"), "frames.csv");
    EXPECT_EQ(files.at("--json"), "");
    EXPECT_TRUE(files.any());
}

}  // namespace
}  // namespace demolish
