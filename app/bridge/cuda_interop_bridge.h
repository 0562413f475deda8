// SPDX-License-Identifier: Apache-2.0
// Zero copies: GL's buffers are registered with CUDA once and mapped together once a frame.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/bridge/cuda_projectiles.h"
#include "app/bridge/frame_bridge.h"
#include "app/bridge/stream_layout.h"

struct cudaGraphicsResource;
struct CUstream_st;

namespace demolish {

class CudaInteropBridge : public FrameBridge {
  public:
    /// Null, with the reason in one clause, when the GPU that draws is another one or registration fails.
    /// Maps on the solver's stream.
    static std::unique_ptr<CudaInteropBridge> tryMake(engine::FractureMesh& mesh, const Solver& solver,
                                                      std::string& why_not);
    ~CudaInteropBridge() override;
    CudaInteropBridge(const CudaInteropBridge&) = delete;
    CudaInteropBridge& operator=(const CudaInteropBridge&) = delete;

    void transfer(Solver& solver, const FrameRequest& request) override;
    void prepare() override;
    void release() override { unmap(); }
    Transfer kind() const override { return Transfer::kInterop; }

  private:
    CudaInteropBridge(engine::FractureMesh& mesh, CUstream_st* stream) : mesh_(mesh), stream_(stream) {}
    void map(std::span<const engine::StreamId> streams);  ///< those that are not yet
    int unmap();                                          ///< cudaError_t
    /// Maps those of these streams that are not yet mapped, lets the solver write them and the tap read them,
    /// and unmaps what is mapped.
    void exportMapped(Solver& solver, std::span<const engine::StreamId> streams, FrameChange change,
                      const FrameRequest& request);

    engine::FractureMesh& mesh_;
    CUstream_st* stream_;  ///< cudaStream_t
    std::array<cudaGraphicsResource*, kStreamCount> resources_{};
    std::vector<cudaGraphicsResource*> mapped_;
    CudaProjectiles projectile_block_;
    PinnedMemory colours_;
    std::array<PinnedMemory, kStreamCount> copies_;  ///< of streams, for a tap
    ExportHistory history_;
};

/// Tries a small buffer of the current context; `why_not` gets the reason in one clause.
bool interopWorks(std::string& why_not);

}  // namespace demolish
