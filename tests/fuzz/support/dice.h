// SPDX-License-Identifier: Apache-2.0
// Random numbers that are the same on every machine: the library's distributions are not.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace demolish::fuzz {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Dice {
  public:
    /// The `index`-th sequence of `seed`.
    Dice(uint64_t seed, uint64_t index) : state_(seed * 0x9e3779b97f4a7c15u) {
        state_ = next() ^ (index * 0xd1342543de82ef95u);
    }

    uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// 0 <= value < count, count > 0.
    size_t below(size_t count) { return static_cast<size_t>(next() % count); }
    /// from <= value < to
    double uniform(double from, double to) {
        return from + (to - from) * static_cast<double>(next() >> 11) * 0x1p-53;
    }
    /// As many values in each decade; 0 < from < to.
    double logUniform(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    template <class List>
    const auto& pick(const List& list) {
        return list[below(list.size())];
    }

  private:
    uint64_t state_;
};

}  // namespace demolish::fuzz
