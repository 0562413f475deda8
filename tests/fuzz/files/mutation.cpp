// SPDX-License-Identifier: Apache-2.0
// Each kind of damage is a function of the bytes.
#include "tests/fuzz/files/mutation.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace demolish::fuzz {
namespace {

using Damage = void (*)(std::string&, Dice&);
constexpr size_t kMostBytes = 4u << 20;

/// Some place in the bytes, the end included.
size_t place(const std::string& bytes, Dice& dice) {
    return dice.below(bytes.size() + 1);
}

/// Headers are short and decide everything: half of all places lie among the first bytes.
size_t earlyPlace(const std::string& bytes, Dice& dice) {
    return dice.chance(0.5) ? dice.below(std::min<size_t>(bytes.size(), 200) + 1) : place(bytes, dice);
}

void turnBits(std::string& bytes, Dice& dice) {
    if (bytes.empty()) return;
    const size_t turns = 1 + dice.below(8);
    for (size_t k = 0; k < turns; ++k) {
        const size_t at = std::min(earlyPlace(bytes, dice), bytes.size() - 1);
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << dice.below(8)));
    }
}

void setBytes(std::string& bytes, Dice& dice) {
    if (bytes.empty()) return;
    const size_t at = std::min(earlyPlace(bytes, dice), bytes.size() - 1);
    bytes[at] = static_cast<char>(dice.below(256));
}

void cutEnd(std::string& bytes, Dice& dice) {
    bytes.resize(place(bytes, dice));
}

void cutMiddle(std::string& bytes, Dice& dice) {
    const size_t at = place(bytes, dice);
    bytes.erase(at, dice.below(bytes.size() - at + 1));
}

void repeatPart(std::string& bytes, Dice& dice) {
    const size_t from = place(bytes, dice);
    const std::string part = bytes.substr(from, dice.below(4000));
    bytes.insert(place(bytes, dice), part);
}

void swapParts(std::string& bytes, Dice& dice) {
    const size_t length = std::min<size_t>(bytes.size() / 3, 1 + dice.below(64));
    if (length == 0) return;
    const size_t a = dice.below(bytes.size() - length), b = dice.below(bytes.size() - length);
    if (a + length > b && b + length > a) return;
    std::swap_ranges(bytes.begin() + static_cast<ptrdiff_t>(a),
                     bytes.begin() + static_cast<ptrdiff_t>(a + length),
                     bytes.begin() + static_cast<ptrdiff_t>(b));
}

/// Counts and offsets of binary formats.
void hugeWord(std::string& bytes, Dice& dice) {
    static constexpr std::array<uint64_t, 10> kWords = {
        0xffffffffu, 0x7fffffffu,         0x80000000u, 0x10000000u, 0xfffffffeu,
        0,           0x7fffffffffffffffu, 1u << 24,    65535,       0x4141414141414141u};
    const size_t width = dice.chance(0.7) ? 4 : 8;
    if (bytes.size() < width) return;
    const uint64_t word = dice.pick(kWords);
    size_t at = std::min(earlyPlace(bytes, dice), bytes.size() - width);
    if (dice.chance(0.5)) at -= at % 4;
    std::memcpy(bytes.data() + at, &word, width);  // little-endian, as the formats are
}

bool isOfANumber(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

/// A number of a text becomes another one, or none.
void oddNumber(std::string& bytes, Dice& dice) {
    static constexpr std::array<std::string_view, 18> kNumbers = {"nan",
                                                                  "inf",
                                                                  "-inf",
                                                                  "1e999",
                                                                  "-1e999",
                                                                  "1e-320",
                                                                  "4294967295",
                                                                  "2147483648",
                                                                  "-1",
                                                                  "0",
                                                                  "1e30",
                                                                  "-1e30",
                                                                  "99999999999999999999",
                                                                  "0x10",
                                                                  "1.2.3",
                                                                  "--1",
                                                                  "",
                                                                  "9007199254740993"};
    size_t at = earlyPlace(bytes, dice);
    while (at < bytes.size() && !isOfANumber(bytes[at])) ++at;
    size_t end = at;
    while (end < bytes.size() && isOfANumber(bytes[end])) ++end;
    bytes.replace(at, end - at, dice.pick(kNumbers));
}

void nest(std::string& bytes, Dice& dice) {
    static constexpr std::array<std::string_view, 7> kOpen = {"[", "{", "(", "{\"a\":", "[[", "a = [", "<a>"};
    const std::string_view open = dice.pick(kOpen);
    const size_t depth = static_cast<size_t>(dice.logUniform(10, 200000));
    std::string nested;
    for (size_t k = 0; k < depth; ++k) nested += open;
    if (dice.chance(0.3)) bytes.clear();
    bytes.insert(place(bytes, dice), nested);
}

size_t lineBegin(const std::string& bytes, size_t at) {
    if (at == 0) return 0;
    const size_t before = bytes.rfind('\n', at - 1);
    return before == std::string::npos ? 0 : before + 1;
}

void repeatLine(std::string& bytes, Dice& dice) {
    const size_t begin = lineBegin(bytes, place(bytes, dice));
    const size_t end = std::min(bytes.find('\n', begin), bytes.size());
    const std::string line = bytes.substr(begin, end - begin) + "\n";
    const size_t times = dice.chance(0.9) ? 1 : 2000;
    for (size_t k = 0; k < times && bytes.size() < kMostBytes; ++k) bytes.insert(begin, line);
}

void dropLine(std::string& bytes, Dice& dice) {
    const size_t begin = lineBegin(bytes, place(bytes, dice));
    const size_t end = std::min(bytes.find('\n', begin), bytes.size());
    bytes.erase(begin, end - begin + 1);
}

void longLine(std::string& bytes, Dice& dice) {
    static constexpr std::array<char, 6> kFill = {'1', 'x', ' ', '"', '/', '.'};
    bytes.insert(place(bytes, dice), static_cast<size_t>(dice.logUniform(300, 300000)), dice.pick(kFill));
}

void zeros(std::string& bytes, Dice& dice) {
    bytes.insert(earlyPlace(bytes, dice), 1 + dice.below(40), '\0');
}

void otherByteOrder(std::string& bytes, Dice& dice) {
    const size_t from = place(bytes, dice), count = dice.below(400);
    for (size_t at = from; at + 4 <= bytes.size() && at < from + count; at += 4)
        std::reverse(bytes.begin() + static_cast<ptrdiff_t>(at),
                     bytes.begin() + static_cast<ptrdiff_t>(at + 4));
}

constexpr std::array<Damage, 16> kDamages = {
    turnBits,  turnBits,  setBytes, cutEnd,     cutMiddle, repeatPart, swapParts, hugeWord,
    oddNumber, oddNumber, nest,     repeatLine, dropLine,  longLine,   zeros,     otherByteOrder};

}  // namespace

std::string mutated(std::string bytes, Dice& dice) {
    const size_t damages = dice.chance(0.6) ? 1 : 2 + dice.below(3);
    for (size_t k = 0; k < damages; ++k) dice.pick(kDamages)(bytes, dice);
    return bytes;
}

}  // namespace demolish::fuzz
