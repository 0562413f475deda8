// SPDX-License-Identifier: Apache-2.0
// Memory of the host that the GPU writes and copies into directly.
#pragma once
#include <cstddef>

namespace demolish {

class PinnedMemory {
  public:
    PinnedMemory() = default;
    ~PinnedMemory();
    PinnedMemory(const PinnedMemory&) = delete;
    PinnedMemory& operator=(const PinnedMemory&) = delete;

    /// At least so many bytes; what was there is lost where there were fewer. Throws DeviceError.
    void* atLeast(size_t bytes);
    void* data() const { return data_; }

  private:
    void* data_ = nullptr;
    size_t bytes_ = 0;
};

}  // namespace demolish
