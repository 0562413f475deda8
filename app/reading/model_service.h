// SPDX-License-Identifier: Apache-2.0
// The reader's own side: what `demolish read-model FILE NODE...` and `demolish read-set FILE` do, for
// model_reader.h and nobody else.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish {

/// The word that makes the program serve a model file.
inline constexpr const char *kReadModelCommand = "read-model", *kReadSetCommand = "read-set";

/// Reads the file, or nodes of it, under limits (reading_limits.h), writes an answer a node (mesh_stream.h)
/// to stdout and ends the process: 0, or kOutOfMemory. After a refusal comes nothing more. A file that kills
/// it is what it is for.
[[noreturn]] void serveModel(const std::filesystem::path& file, const std::vector<std::string>& nodes);
/// The same, but tells what stands in the file.
[[noreturn]] void serveSet(const std::filesystem::path& file);

}  // namespace demolish
