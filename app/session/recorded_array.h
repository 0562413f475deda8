// SPDX-License-Identifier: Apache-2.0
// Memory for megabytes that are kept as they are.
#pragma once
#include <cstddef>
#include <memory>
#include <span>

namespace demolish {

/// Copies `bytes` of memory into memory that has never been written: by several threads and, where the system
/// can, in pages of two megabytes, since it takes longer to be handed out than to be filled.
void copyIntoNewMemory(void* to, const void* from, size_t bytes);

/// A copy of so many values, which are trivially copyable; empty by default. Move-only.
template <class T>
class RecordedArray {
  public:
    RecordedArray() = default;
    explicit RecordedArray(std::span<const T> values)
        : memory_(std::make_unique_for_overwrite<T[]>(values.size())), count_(values.size()) {
        copyIntoNewMemory(memory_.get(), values.data(), values.size_bytes());
    }
    std::span<const T> span() const { return {memory_.get(), count_}; }

  private:
    std::unique_ptr<T[]> memory_;
    size_t count_ = 0;
};

}  // namespace demolish
