// CUDA-GL interop. The only file that sees cuda_gl_interop.h.
#include "app/bridge/cuda_interop_bridge.h"

#include <glad/gl.h>
// After the loader: it brings GL/gl.h along.
#include <cuda_gl_interop.h>

#include <algorithm>

#include "app/bridge/cuda_check.h"

namespace demolish {
namespace {

/// CUDA's present device must be among those that the current GL context draws with.
bool contextIsOnCudaDevice(std::string& why_not) {
    unsigned count = 0;
    std::array<int, 16> devices{};
    const cudaError_t error = cudaGLGetDevices(&count, devices.data(), devices.size(), cudaGLDeviceListAll);
    if (error != cudaSuccess) {
        cudaGetLastError();  // a failed question must not fail the next call
        why_not = std::string("OpenGL draws on a device that CUDA does not know (") +
                  cudaGetErrorString(error) + ")";
        return false;
    }
    int current = 0;
    checkCuda(cudaGetDevice(&current), "cudaGetDevice");
    if (std::find(devices.begin(), devices.begin() + count, current) == devices.begin() + count) {
        why_not = "OpenGL draws on another GPU than CUDA device " + std::to_string(current);
        return false;
    }
    return true;
}

/// No discard flag: the draw lists keep their contents while nothing breaks.
cudaError_t registerBuffer(cudaGraphicsResource*& resource, GLuint buffer) {
    const cudaError_t error = cudaGraphicsGLRegisterBuffer(&resource, buffer, cudaGraphicsRegisterFlagsNone);
    if (error != cudaSuccess) cudaGetLastError();
    return error;
}

}  // namespace

std::unique_ptr<CudaInteropBridge> CudaInteropBridge::tryMake(engine::FractureMesh& mesh,
                                                              std::string& why_not) {
    if (!contextIsOnCudaDevice(why_not)) return nullptr;
    std::unique_ptr<CudaInteropBridge> bridge(new CudaInteropBridge(mesh.particleCount()));
    for (size_t i = 0; i < kStreamCount; ++i) {
        const cudaError_t error =
            registerBuffer(bridge->resources_[i], mesh.stream(static_cast<engine::StreamId>(i)).id());
        if (error == cudaSuccess) continue;
        why_not = std::string("registration of a GL buffer failed: ") + cudaGetErrorString(error);
        return nullptr;
    }
    return bridge;
}

CudaInteropBridge::~CudaInteropBridge() {
    for (auto* resource : resources_)
        if (resource != nullptr) cudaGraphicsUnregisterResource(resource);
}

void CudaInteropBridge::transfer(Solver& solver, ParticleColour colour, uint32_t projectiles, bool fresh) {
    checkCuda(cudaGraphicsMapResources(kStreamCount, resources_.data(), nullptr), "mapping GL's buffers");
    std::array<void*, kStreamCount> data{};
    std::array<size_t, kStreamCount> bytes{};
    for (size_t i = 0; i < kStreamCount; ++i)
        checkCuda(cudaGraphicsResourceGetMappedPointer(&data[i], &bytes[i], resources_[i]),
                  "mapping a GL buffer");
    const RenderStreams streams = streamsAt(data, bytes, colour);
    solver.exportFrame(streams, fresh);
    solver.synchronize();  // the solver's stream is its own; unmapping orders only stream 0

    const size_t first = std::min(particle_count_, streams.particles.capacity);
    const size_t last = std::min(particle_count_ + projectiles, streams.particles.capacity);
    projectiles_.resize(last - first);
    if (last > first)
        checkCuda(cudaMemcpy(projectiles_.data(), streams.particles.data + first,
                             projectiles_.size() * sizeof(ParticleInstance), cudaMemcpyDeviceToHost),
                  "reading the projectiles");
    checkCuda(cudaGraphicsUnmapResources(kStreamCount, resources_.data(), nullptr), "unmapping GL's buffers");
}

bool interopWorks(std::string& why_not) {
    if (!contextIsOnCudaDevice(why_not)) return false;
    auto buffer = engine::gl::Buffer::resizable(4096);
    cudaGraphicsResource* resource = nullptr;
    const cudaError_t error = registerBuffer(resource, buffer.id());
    if (error != cudaSuccess) {
        why_not = std::string("registration of a GL buffer failed: ") + cudaGetErrorString(error);
        return false;
    }
    cudaGraphicsUnregisterResource(resource);
    return true;
}

}  // namespace demolish
