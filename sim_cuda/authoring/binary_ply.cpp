// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/binary_ply.h"

#include <fstream>
#include <iterator>
#include <string_view>

namespace demolish {
namespace {

constexpr size_t kMostHeader = 1 << 20;  ///< bytes

/// Of a binary file whose header's lines end with one character; nothing, if `head` is not the begin of such.
std::optional<size_t> beginOfNumbers(std::string_view head) {
    constexpr std::string_view kEnd = "\nend_header\n";
    const size_t end = head.find(kEnd);
    if (!head.starts_with("ply\n") || end == head.npos || head.find("\nformat binary") > end) return {};
    return end + kEnd.size();
}

}  // namespace

std::optional<std::string> plyWithOneMore(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string bytes(kMostHeader, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(in.gcount()));
    const std::optional<size_t> begin = beginOfNumbers(bytes);
    if (!begin || *begin == bytes.size() || bytes[*begin] != '\n') return {};
    bytes.append(std::istreambuf_iterator<char>(in), {});
    bytes.insert(*begin, 1, '\n');
    return bytes;
}

}  // namespace demolish
