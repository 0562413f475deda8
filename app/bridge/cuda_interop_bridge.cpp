// SPDX-License-Identifier: Apache-2.0
// CUDA-GL interop. The only file that sees cuda_gl_interop.h.
#include "app/bridge/cuda_interop_bridge.h"

#include <glad/gl.h>
// After the loader: it brings GL/gl.h along.
#include <cuda_gl_interop.h>

#include <algorithm>
#include <span>
#include <utility>

#include "app/bridge/cuda_check.h"
#include "app/bridge/cuda_stream.h"
#include "engine/render/fracture_mesh.h"

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
                                                              const Solver& solver, std::string& why_not) {
    if (!contextIsOnCudaDevice(why_not)) return nullptr;
    std::unique_ptr<CudaInteropBridge> bridge(new CudaInteropBridge(mesh, streamOf(solver)));
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

void CudaInteropBridge::map(std::span<const engine::StreamId> ids) {
    std::vector<cudaGraphicsResource*> missing;
    for (const engine::StreamId id : ids) {
        auto* resource = resources_[static_cast<size_t>(id)];
        if (std::find(mapped_.begin(), mapped_.end(), resource) == mapped_.end()) missing.push_back(resource);
    }
    if (missing.empty()) return;
    checkCuda(cudaGraphicsMapResources(static_cast<int>(missing.size()), missing.data(), stream_),
              "mapping GL's buffers");
    mapped_.insert(mapped_.end(), missing.begin(), missing.end());
}

/// While nothing moves, the next frame will hardly need them.
void CudaInteropBridge::prepare() {
    if (mapped_.empty() && history_.moved()) map(streamsOf(FrameChange::kAll, mesh_.effectsShown()));
}

int CudaInteropBridge::unmap() {
    if (mapped_.empty()) return cudaSuccess;
    auto mapped = std::exchange(mapped_, {});
    return cudaGraphicsUnmapResources(static_cast<int>(mapped.size()), mapped.data(), stream_);
}

void CudaInteropBridge::exportMapped(Solver& solver, std::span<const engine::StreamId> ids,
                                     FrameChange change, const FrameRequest& request) {
    map(ids);
    std::array<void*, kStreamCount> data{};
    std::array<size_t, kStreamCount> bytes{};
    for (const engine::StreamId id : ids) {
        const auto i = static_cast<size_t>(id);
        checkCuda(cudaGraphicsResourceGetMappedPointer(&data[i], &bytes[i], resources_[i]),
                  "mapping a GL buffer");
    }
    RenderStreams streams = streamsAt(data, bytes, request.colour);
    streams.projectiles = projectile_block_.stream();
    const size_t tapped = request.tap && !ids.empty() ? mesh_.particleCount() : 0;
    if (tapped > 0) streams.colours = colourStreamsAt(colours_.atLeast(kColours * tapped), tapped);
    solver.exportFrame(streams, request.fresh);
    solver.synchronize();
    const auto read = [&](engine::StreamId id, size_t first, size_t size) {
        const auto i = static_cast<size_t>(id);
        auto* copy = static_cast<std::byte*>(copies_[i].atLeast(size));
        copyToHost(copy, static_cast<const std::byte*>(data[i]) + first, size, stream_, "copying the frame");
        return std::span<const std::byte>(copy, size);
    };
    if (request.tap) request.tap(change, read, colourBytesAt(colours_.data(), tapped));
    checkCuda(static_cast<cudaError_t>(unmap()), "unmapping GL's buffers");
}

void CudaInteropBridge::transfer(Solver& solver, const FrameRequest& request) {
    const FrameChange change = history_.next(solver.stats(), request.colour, request.fresh);
    const bool with_effects = solver.stats().effects_shown;
    exportMapped(solver, streamsOf(change, with_effects), change, request);
    mesh_.showEffects(with_effects, solver.stats().effects_moving);
    if (change != FrameChange::kProjectiles) mesh_.touch();
    projectile_block_.read(request.projectiles, projectiles_);
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
