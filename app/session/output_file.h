// Text files that are whole or not there: written under a temporary name, then renamed.
#pragma once
#include <filesystem>
#include <string>

namespace demolish {

/// Throws OutputError that names the file and the reason (no such folder, no permission, disk full).
void writeTextFile(const std::filesystem::path& file, const std::string& text);
/// Makes the folder and its parents; throws OutputError. Also checks that a file can be made in it.
void makeOutputFolder(const std::filesystem::path& folder);

}  // namespace demolish
