// SPDX-License-Identifier: Apache-2.0
// Goes through the list of formats; knows none of them.
#include "app/commands/run_files.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace demolish {
namespace {

/// Null where the command does not offer the format.
const char* optionOf(const RunFormat& format, RunCommand command) {
    return command == RunCommand::kCapture ? format.capture_option : format.bench_option;
}

}  // namespace

bool RunFiles::any() const {
    return std::any_of(paths.begin(), paths.end(), [](const auto& file) { return !file.second.empty(); });
}

void addRunFileOptions(CLI::App& command, RunFiles& files) {
    for (const RunFormat& format : kRunFormats)
        if (const char* option = optionOf(format, files.command))
            command.add_option(option, files.paths[option], format.help)->type_name("FILE");
}

void requireWritable(const RunFiles& files) {
    for (const auto& [option, file] : files.paths)
        if (!file.empty()) requireWritable(std::filesystem::path(file));
}

void writeRunFiles(const RunFiles& files, FinishedRun& run, LastFiles& last) {
    for (const RunFormat& format : kRunFormats)
        if (const char* option = optionOf(format, files.command))
            last.write(files.at(option), [&] { return format.make(run); });
}

}  // namespace demolish
