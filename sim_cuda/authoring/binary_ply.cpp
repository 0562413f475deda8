// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/binary_ply.h"

#include <fstream>
#include <iterator>

namespace demolish {
namespace {

constexpr size_t kMostHeader = 1 << 20;  ///< bytes

/// Where the numbers of a binary file begin; nothing, if there is no such place.
std::optional<size_t> beginOfNumbers(std::istream& in) {
    bool binary = false;
    size_t begin = 0;
    for (std::string line; begin < kMostHeader && std::getline(in, line); line.clear()) {
        if (begin == 0 && line != "ply") return {};
        begin += line.size() + 1;
        binary = binary || line.starts_with("format binary");
        if (line == "end_header") return binary ? std::optional(begin) : std::nullopt;
    }
    return {};
}

}  // namespace

std::optional<std::string> plyWithOneMore(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::optional<size_t> begin = beginOfNumbers(in);
    if (!begin || in.peek() != '\n') return {};
    in.seekg(0);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    bytes.insert(*begin, 1, '\n');
    return bytes;
}

}  // namespace demolish
