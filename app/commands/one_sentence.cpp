// SPDX-License-Identifier: Apache-2.0
// Byte by byte; a letter of several bytes is kept or left out as a whole.
#include "app/commands/one_sentence.h"

#include <cstddef>
#include <cstdint>

namespace demolish {
namespace {

constexpr size_t kMostBytes = 1000, kHead = 600;

bool continues(char byte) {
    return (static_cast<uint8_t>(byte) & 0xc0) == 0x80;
}

/// Bytes of the UTF-8 letter at `at`, 0 if there is none.
size_t letterAt(const std::string& text, size_t at) {
    const auto first = static_cast<uint8_t>(text[at]);
    const size_t bytes = first < 0x80                    ? 1
                         : first >= 0xc2 && first < 0xe0 ? 2
                         : first >= 0xe0 && first < 0xf0 ? 3
                         : first >= 0xf0 && first < 0xf5 ? 4
                                                         : 0;
    if (bytes == 0 || at + bytes > text.size()) return 0;
    for (size_t k = 1; k < bytes; ++k)
        if (!continues(text[at + k])) return 0;
    return bytes;
}

std::string plain(const std::string& text) {
    std::string line;
    for (size_t at = 0; at < text.size();) {
        const size_t bytes = letterAt(text, at);
        const auto first = static_cast<uint8_t>(text[at]);
        if (bytes == 0)
            line += '?';
        else if (first < 0x20 || first == 0x7f)
            line += ' ';
        else
            line.append(text, at, bytes);
        at += bytes == 0 ? 1 : bytes;
    }
    return line;
}

}  // namespace

std::string oneSentence(const std::string& text) {
    const std::string line = plain(text);
    if (line.size() <= kMostBytes) return line;
    size_t head = kHead, tail = line.size() - (kMostBytes - kHead);
    while (continues(line[head])) --head;
    while (tail < line.size() && continues(line[tail])) ++tail;
    return line.substr(0, head) + " ... " + line.substr(tail);
}

}  // namespace demolish
