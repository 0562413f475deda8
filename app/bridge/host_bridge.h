// SPDX-License-Identifier: Apache-2.0
// The way of a CPU solver's frame: written into plain memory, uploaded to GL; draw lists only when they
// changed.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "app/bridge/frame_bridge.h"
#include "app/bridge/stream_layout.h"

namespace demolish {

class HostBridge : public FrameBridge {
  public:
    explicit HostBridge(engine::FractureMesh& mesh);
    void transfer(Solver& solver, const FrameRequest& request) override;
    Transfer kind() const override { return Transfer::kHost; }

  private:
    void upload(engine::StreamId id, size_t elements, size_t first = 0);
    void uploadStreams(const RenderStreams& streams, FrameChange change);

    engine::FractureMesh& mesh_;
    std::array<size_t, kStreamCount> bytes_;
    std::array<std::unique_ptr<std::byte[]>, kStreamCount> memory_;  ///< untouched pages cost nothing
    std::vector<uint8_t> colours_;
    ExportHistory history_;
};

}  // namespace demolish
