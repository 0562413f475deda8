// SPDX-License-Identifier: Apache-2.0
// Text files that are whole or not there: written under a temporary name of their own in the same folder,
// then renamed.
#pragma once
#include <filesystem>
#include <string>

namespace demolish {

/// What is there stays until the whole text can take its place; of several writers the last one wins. A link
/// stays one, pipes and devices are written into. Throws OutputError that names the file and the reason (no
/// such folder, no permission, disk full).
void writeTextFile(const std::filesystem::path& file, const std::string& text);
/// Throws OutputError if the file could not be written as things are now: before hours of work, not after.
/// Leaves nothing behind.
void requireWritable(const std::filesystem::path& file);
/// Makes the folder and its parents; throws OutputError. Also checks that a file can be made in it.
void makeOutputFolder(const std::filesystem::path& folder);

}  // namespace demolish
