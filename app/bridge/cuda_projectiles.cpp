// One small block of device memory.
#include "app/bridge/cuda_projectiles.h"

#include "app/bridge/cuda_check.h"
#include "sim_cuda/api/params.h"

namespace demolish {

CudaProjectiles::CudaProjectiles() {
    checkCuda(cudaMalloc(&memory_, kMaxProjectiles * sizeof(ParticleInstance)),
              "allocating memory for projectiles");
}

CudaProjectiles::~CudaProjectiles() {
    cudaFree(memory_);
}

Stream<ParticleInstance> CudaProjectiles::stream() const {
    return {static_cast<ParticleInstance*>(memory_), kMaxProjectiles};
}

void CudaProjectiles::read(uint32_t count, std::vector<ParticleInstance>& projectiles) const {
    projectiles.resize(count);
    if (count == 0) return;
    checkCuda(
        cudaMemcpy(projectiles.data(), memory_, count * sizeof(ParticleInstance), cudaMemcpyDeviceToHost),
        "reading the projectiles");
}

}  // namespace demolish
