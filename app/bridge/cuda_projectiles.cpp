// SPDX-License-Identifier: Apache-2.0
// One small block of the host's memory that the GPU writes into.
#include "app/bridge/cuda_projectiles.h"

#include "sim_cuda/api/params.h"

namespace demolish {

CudaProjectiles::CudaProjectiles() {
    memory_.atLeast(kMaxProjectiles * sizeof(ParticleInstance));
}

Stream<ParticleInstance> CudaProjectiles::stream() const {
    return {static_cast<ParticleInstance*>(memory_.data()), kMaxProjectiles};
}

void CudaProjectiles::read(uint32_t count, std::vector<ParticleInstance>& projectiles) const {
    const auto* first = static_cast<const ParticleInstance*>(memory_.data());
    projectiles.assign(first, first + count);
}

}  // namespace demolish
