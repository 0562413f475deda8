// SPDX-License-Identifier: Apache-2.0
// What of a frame casts shadow.
#pragma once
#include <span>

#include "engine/passes/shadow_pass.h"
#include "engine/render/frame_uniforms.h"

namespace demolish::engine {

/// `near`: of the mesh, null: none.
ShadowScene shadowSceneOf(const FractureMesh* mesh, const FrameView& view, const NearFaces* near,
                          std::span<const SphereDraw> spheres, const FrameUniforms& frame);

}  // namespace demolish::engine
