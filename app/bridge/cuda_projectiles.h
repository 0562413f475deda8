// Where the GPU writes the projectiles of a frame, and their way to the host: a kilobyte of its own, so that
// GL's buffers need no mapping while only a ball flies.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/api/render_streams.h"

namespace demolish {

class CudaProjectiles {
  public:
    /// Throws DeviceError when the GPU has no kilobyte left.
    CudaProjectiles();
    ~CudaProjectiles();
    CudaProjectiles(const CudaProjectiles&) = delete;
    CudaProjectiles& operator=(const CudaProjectiles&) = delete;

    Stream<ParticleInstance> stream() const;
    /// Copies the first `count` of a finished export. Throws DeviceError.
    void read(uint32_t count, std::vector<ParticleInstance>& projectiles) const;

  private:
    void* memory_ = nullptr;
};

}  // namespace demolish
