// SPDX-License-Identifier: Apache-2.0
// The drawable side of a running shot: GL buffers of its geometry and the bridge that fills them. No solver
// state.
#pragma once
#include <memory>
#include <vector>

#include "app/bridge/frame_bridge.h"
#include "app/session/built_shot.h"
#include "engine/scene/frame_view.h"

namespace demolish {

class FrameOutput {
  public:
    /// The GL context must be current, here and in every other call.
    explicit FrameOutput(const BuiltShot& built);
    ~FrameOutput();
    FrameOutput(const FrameOutput&) = delete;
    FrameOutput& operator=(const FrameOutput&) = delete;

    FrameBridge& bridge() { return *bridge_; }
    const FrameBridge& bridge() const { return *bridge_; }
    engine::FractureMesh& mesh() { return *mesh_; }
    const engine::FractureMesh& mesh() const { return *mesh_; }

  private:
    std::unique_ptr<engine::FractureMesh> mesh_;
    std::unique_ptr<FrameBridge> bridge_;
};

std::vector<engine::SphereDraw> spheresOf(std::span<const ParticleInstance> projectiles);

}  // namespace demolish
