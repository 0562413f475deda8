// SPDX-License-Identifier: Apache-2.0
// The files that Demolish reads: whole ones to damage, and the command that reads a file as users do.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace demolish::fuzz {

/// How a file comes to the program.
struct ReadingCommand {
    std::vector<std::string> words;  ///< without the program
    std::vector<std::string> environment;
};

struct FileFormat {
    std::string name;                ///< "glb"
    std::vector<std::string> seeds;  ///< contents of whole files
    /// Puts the bytes where the program looks for them, in a folder of its own.
    std::function<ReadingCommand(const std::string& bytes, const std::filesystem::path& folder)> place;
    /// It says speeds and materials, and so may say what no step can bear: exit 5.
    bool may_fly_apart = false;
};

/// All of them; `folder` is for what is made once.
std::vector<FileFormat> fileFormats(const std::filesystem::path& folder);

}  // namespace demolish::fuzz
