// SPDX-License-Identifier: Apache-2.0
// Binary PLY files that the importer would begin to read at the wrong place.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace demolish {

/// The importer leaves out a line's end right after the header, as the second half of the one that ends it.
/// Where the header ends with one character, that is the first byte of a number: the file's bytes, with one
/// more to leave out. Nothing, if the file can be read as it is, or is no PLY file.
std::optional<std::string> plyWithOneMore(const std::filesystem::path& file);

}  // namespace demolish
