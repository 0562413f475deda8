// SPDX-License-Identifier: Apache-2.0
// Small pieces that reports are written with.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish {

/// printf into a string of at most 255 characters.
std::string formatted(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

/// The file's own name, of which nothing but text is left.
std::string modelName(const std::filesystem::path& model);

/// One line of a CSV file, RFC 4180: a field with a comma, quote or line end stands in quotes.
std::string csvLine(const std::vector<std::string>& fields);

}  // namespace demolish
