// SPDX-License-Identifier: Apache-2.0
// Where the GPU writes the projectiles of a frame: a kilobyte of the host's memory, so that GL's buffers need
// no mapping while only a ball flies, and nothing has to be copied.
#pragma once
#include <cstdint>
#include <vector>

#include "app/bridge/cuda_pinned_memory.h"
#include "sim_cuda/api/render_streams.h"

namespace demolish {

class CudaProjectiles {
  public:
    /// Throws DeviceError when there is no kilobyte left.
    CudaProjectiles();

    Stream<ParticleInstance> stream() const;
    /// The first `count` of a finished export, at most kMaxProjectiles.
    void read(uint32_t count, std::vector<ParticleInstance>& projectiles) const;

  private:
    PinnedMemory memory_;
};

}  // namespace demolish
