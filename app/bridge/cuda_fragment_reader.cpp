// SPDX-License-Identifier: Apache-2.0
// A block of device memory for one export.
#include "app/bridge/cuda_fragment_reader.h"

#include "app/bridge/cuda_check.h"
#include "app/bridge/cuda_stream.h"

namespace demolish {
namespace {

class DeviceBlock {
  public:
    explicit DeviceBlock(size_t bytes) {
        checkCuda(cudaMalloc(&memory_, bytes), "allocating memory for fragments");
    }
    ~DeviceBlock() { cudaFree(memory_); }
    DeviceBlock(const DeviceBlock&) = delete;
    DeviceBlock& operator=(const DeviceBlock&) = delete;
    void* memory() const { return memory_; }

  private:
    void* memory_ = nullptr;
};

}  // namespace

std::vector<uint32_t> readFragmentsFromGpu(Solver& solver) {
    std::vector<uint32_t> fragments(solver.stats().particles);
    const size_t bytes = fragments.size() * sizeof(uint32_t);
    const DeviceBlock block(bytes);
    RenderStreams streams;
    streams.particle_fragment = {static_cast<uint32_t*>(block.memory()), fragments.size()};
    solver.exportFrame(streams);
    copyToHost(fragments.data(), block.memory(), bytes, streamOf(solver), "copying fragments");
    return fragments;
}

}  // namespace demolish
