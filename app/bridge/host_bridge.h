// The way of a CPU solver's frame: written into plain memory, uploaded to GL; draw lists only when they
// changed.
#pragma once
#include <array>
#include <cstddef>
#include <memory>

#include "app/bridge/frame_bridge.h"
#include "app/bridge/stream_layout.h"

namespace demolish {

class HostBridge : public FrameBridge {
  public:
    explicit HostBridge(engine::FractureMesh& mesh);
    void transfer(Solver& solver, ParticleColour colour, uint32_t projectiles, bool fresh) override;
    Transfer kind() const override { return Transfer::kHost; }

  private:
    engine::FractureMesh& mesh_;
    std::array<size_t, kStreamCount> bytes_;
    std::array<std::unique_ptr<std::byte[]>, kStreamCount> memory_;  ///< untouched pages cost nothing
    ExportHistory history_;
};

/// How much of the draw lists is in use.
struct DrawListUse {
    size_t interior_indices = 0, interior_vertices = 0, exterior_indices = 0, crack_edges = 0;  ///< elements
};
/// Vertices in use follow from the highest index.
DrawListUse drawListUse(const DrawCommands& commands, std::span<const uint32_t> interior_indices);

}  // namespace demolish
