// SPDX-License-Identifier: Apache-2.0
// A GPU cannot write into plain host memory: pinned memory is seen by both.
#include "tests/physics/solver/exported_frame.h"

#include <memory>
#include <stdexcept>

#include "tests/physics/solver/solver_under_test.h"

#if defined(DEMOLISH_WITH_CUDA)
#include <cuda_runtime_api.h>
#endif

namespace demolish::tests {
namespace {

using Bytes = std::unique_ptr<void, void (*)(void*)>;

Bytes memoryOf(size_t bytes) {
#if defined(DEMOLISH_WITH_CUDA)
    if (asksForGpu()) {
        void* memory = nullptr;
        if (cudaMallocHost(&memory, bytes) != cudaSuccess) throw std::runtime_error("no pinned memory");
        return {memory, [](void* pinned) { cudaFreeHost(pinned); }};
    }
#endif
    return {::operator new(bytes), [](void* plain) { ::operator delete(plain); }};
}

}  // namespace

ExportedFrame exportedFrame(Solver& solver, size_t count) {
    const Bytes particles = memoryOf(count * sizeof(ParticleInstance));
    const Bytes fragments = memoryOf(count * sizeof(uint32_t));
    auto* instance = static_cast<ParticleInstance*>(particles.get());
    auto* fragment = static_cast<uint32_t*>(fragments.get());
    RenderStreams streams;
    streams.particles = {instance, count};
    streams.particle_fragment = {fragment, count};
    solver.exportFrame(streams, true);
    solver.synchronize();
    return {{instance, instance + count}, {fragment, fragment + count}};
}

}  // namespace demolish::tests
