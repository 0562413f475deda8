// SPDX-License-Identifier: Apache-2.0
// Memory that a solver writes a frame into and the host reads.
#pragma once
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

namespace demolish {

class FrameMemory {
  public:
    virtual ~FrameMemory() = default;
    /// A block of its own, which the solver's device can write; it lasts as long as this does. bytes > 0.
    virtual void* reserve(size_t bytes) = 0;
    /// From such a block. Waits for what the solver has started.
    virtual void read(void* to, const void* from, size_t bytes) = 0;
};

/// Of a solver on the CPU.
class HostFrameMemory : public FrameMemory {
  public:
    void* reserve(size_t bytes) override {
        blocks_.push_back(std::make_unique_for_overwrite<std::byte[]>(bytes));  // pages not used cost nothing
        return blocks_.back().get();
    }
    void read(void* to, const void* from, size_t bytes) override { std::memcpy(to, from, bytes); }

  private:
    std::vector<std::unique_ptr<std::byte[]>> blocks_;
};

}  // namespace demolish
