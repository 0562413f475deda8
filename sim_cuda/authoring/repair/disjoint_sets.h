// SPDX-License-Identifier: Apache-2.0
// Union-find over numbers 0 to n - 1.
#pragma once
#include <cstdint>
#include <numeric>
#include <vector>

namespace demolish {

class DisjointSets {
  public:
    explicit DisjointSets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    uint32_t find(uint32_t element) {
        while (parent_[element] != element) element = parent_[element] = parent_[parent_[element]];
        return element;
    }
    /// The lower number stands for both, so that the result does not hang on the order of calls.
    void join(uint32_t a, uint32_t b) {
        a = find(a), b = find(b);
        parent_[a < b ? b : a] = a < b ? a : b;
    }
    /// Numbers of the sets by element, in order of their lowest elements; returns how many there are.
    uint32_t number(std::vector<uint32_t>& set_of) {
        set_of.resize(parent_.size());
        uint32_t count = 0;
        for (uint32_t i = 0; i < parent_.size(); ++i) {
            const uint32_t root = find(i);
            set_of[i] = root == i ? count++ : set_of[root];
        }
        return count;
    }

  private:
    std::vector<uint32_t> parent_;
};

}  // namespace demolish
