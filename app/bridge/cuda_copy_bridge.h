// SPDX-License-Identifier: Apache-2.0
// The way of a GPU solver's frame where GL cannot share memory with CUDA: device, pinned host memory, GL.
#pragma once
#include <array>
#include <memory>
#include <string>

#include "app/bridge/cuda_projectiles.h"
#include "app/bridge/frame_bridge.h"
#include "app/bridge/stream_layout.h"

struct CUstream_st;

namespace demolish {

class CudaCopyBridge : public FrameBridge {
  public:
    /// `why_not_interop`: one clause. Throws DeviceError when the GPU's memory does not suffice.
    /// Copies on the solver's stream.
    CudaCopyBridge(engine::FractureMesh& mesh, const Solver& solver, const std::string& why_not_interop);
    ~CudaCopyBridge() override;

    void transfer(Solver& solver, const FrameRequest& request) override;
    Transfer kind() const override { return Transfer::kCopy; }

  private:
    struct Memory;
    /// Copies `elements` of a stream to the host and on to GL; returns the host copy of its first element,
    /// null if there is nothing to copy.
    const std::byte* bring(engine::StreamId id, size_t elements, size_t first = 0);
    void bringStreams(FrameChange change);
    void bringEffects();

    engine::FractureMesh& mesh_;
    CUstream_st* stream_;  ///< cudaStream_t
    std::unique_ptr<Memory> memory_;
    ExportHistory history_;
    CudaProjectiles projectile_block_;
    PinnedMemory colours_;
};

}  // namespace demolish
