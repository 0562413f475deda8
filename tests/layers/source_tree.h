// SPDX-License-Identifier: Apache-2.0
// The repository's own sources as text: which there are, their lines, their code without comments, what they
// include.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish::layers {

/// Source files under folders of the repository, sorted; folders that are not there hold none.
std::vector<std::filesystem::path> sourcesUnder(const std::vector<std::string>& folders);
/// From the repository's root, with slashes.
std::string nameOf(const std::filesystem::path& file);
std::vector<std::string> linesOf(const std::filesystem::path& file);

/// The text with comments and preprocessor lines left out, and strings and characters emptied; lines stay
/// where they are.
std::string codeOf(const std::string& text);
std::string codeOfFile(const std::filesystem::path& file);

/// "engine/gl/buffer.h" or "cuda_runtime.h", in order.
std::vector<std::string> includesIn(const std::vector<std::string>& lines);

}  // namespace demolish::layers
