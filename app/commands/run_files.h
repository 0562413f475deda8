// SPDX-License-Identifier: Apache-2.0
// Which files of a run the user wants (run_formats.h), as options of capture and bench.
#pragma once
#include <CLI/App.hpp>
#include <map>
#include <string>

#include "app/commands/run_formats.h"
#include "app/session/output_file.h"

namespace demolish {

enum class RunCommand { kCapture, kBench };

struct RunFiles {
    RunCommand command;
    std::map<std::string, std::string> paths{};  ///< by option, "--json"; empty: not wanted

    const std::string& at(const std::string& option) const { return paths.at(option); }
    bool any() const;
};

/// `files` must outlive the command.
void addRunFileOptions(CLI::App& command, RunFiles& files);
/// Before the run; throws OutputError (session/output_file.h).
void requireWritable(const RunFiles& files);
/// In the order of the list. What cannot be written is for `last` to tell.
void writeRunFiles(const RunFiles& files, FinishedRun& run, LastFiles& last);

}  // namespace demolish
