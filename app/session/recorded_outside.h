// SPDX-License-Identifier: Apache-2.0
// The outside's vertices as one frame drew them, in blocks that frames share while they are alike.
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "app/bridge/frame_bridge.h"
#include "app/session/recorded_array.h"
#include "sim_cuda/api/render_streams.h"

namespace demolish {

class RecordedOutside {
  public:
    RecordedOutside() = default;
    /// What a tap reads; `before`: of the frame recorded before this one, null for the first.
    RecordedOutside(const RecordedOutside* before, const ReadStream& read, size_t vertices);

    /// Into the mesh's stream.
    void upload(engine::FractureMesh& mesh) const;
    /// Of blocks that the frame before does not have.
    size_t ownBytes() const { return own_bytes_; }

  private:
    /// Chunks of the stream to a block.
    static constexpr size_t kChunks = 16;
    static constexpr size_t kBlock = kChunks * kExteriorChunk;  ///< vertices

    std::vector<std::shared_ptr<const RecordedArray<SurfaceVertex>>> blocks_;
    size_t own_bytes_ = 0;
};

}  // namespace demolish
