// One small block of the host's memory that the GPU writes into.
#include "app/bridge/cuda_projectiles.h"

#include "app/bridge/cuda_check.h"
#include "sim_cuda/api/params.h"

namespace demolish {

CudaProjectiles::CudaProjectiles() {
    checkCuda(cudaMallocHost(&memory_, kMaxProjectiles * sizeof(ParticleInstance)),
              "allocating memory for projectiles");
}

CudaProjectiles::~CudaProjectiles() {
    cudaFreeHost(memory_);
}

Stream<ParticleInstance> CudaProjectiles::stream() const {
    return {static_cast<ParticleInstance*>(memory_), kMaxProjectiles};
}

void CudaProjectiles::read(uint32_t count, std::vector<ParticleInstance>& projectiles) const {
    const auto* first = static_cast<const ParticleInstance*>(memory_);
    projectiles.assign(first, first + count);
}

}  // namespace demolish
