// Zero copies: GL's buffers are registered with CUDA once and mapped together once a frame.
#pragma once
#include <array>
#include <memory>
#include <string>

#include "app/bridge/cuda_projectiles.h"
#include "app/bridge/frame_bridge.h"
#include "app/bridge/stream_layout.h"

struct cudaGraphicsResource;

namespace demolish {

class CudaInteropBridge : public FrameBridge {
  public:
    /// Null, with the reason in one clause, when the GPU that draws is another one or registration fails.
    static std::unique_ptr<CudaInteropBridge> tryMake(engine::FractureMesh& mesh, std::string& why_not);
    ~CudaInteropBridge() override;
    CudaInteropBridge(const CudaInteropBridge&) = delete;
    CudaInteropBridge& operator=(const CudaInteropBridge&) = delete;

    void transfer(Solver& solver, ParticleColour colour, uint32_t projectiles, bool fresh) override;
    Transfer kind() const override { return Transfer::kInterop; }

  private:
    explicit CudaInteropBridge(engine::FractureMesh& mesh) : mesh_(mesh) {}
    /// Maps these streams, lets the solver write them, and unmaps them.
    void exportMapped(Solver& solver, std::span<const engine::StreamId> streams, ParticleColour colour,
                      bool fresh);

    engine::FractureMesh& mesh_;
    std::array<cudaGraphicsResource*, kStreamCount> resources_{};
    CudaProjectiles projectile_block_;
    ExportHistory history_;
};

/// Tries a small buffer of the current context; `why_not` gets the reason in one clause.
bool interopWorks(std::string& why_not);

}  // namespace demolish
