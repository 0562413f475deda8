// SPDX-License-Identifier: Apache-2.0
// The reader's own side: what `demolish read-model FILE NODE` does, for model_reader.h and nobody else.
#pragma once
#include <filesystem>
#include <string>

namespace demolish {

/// The word that makes the program serve a model file.
inline constexpr const char* kReadModelCommand = "read-model";

/// Reads the file, or a node of it, under limits (reading_limits.h), writes the answer (mesh_stream.h) to
/// stdout and ends the process: 0, or kOutOfMemory. A file that kills it is what it is for.
[[noreturn]] void serveModel(const std::filesystem::path& file, const std::string& node);

}  // namespace demolish
