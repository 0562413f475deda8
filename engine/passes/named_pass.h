// SPDX-License-Identifier: Apache-2.0
// Draws the small triangles that the CPU has found (SmallTriangles): first the materials of all their
// records, close together, then those of the samples that show them.
#pragma once
#include <array>
#include <filesystem>
#include <map>

#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/gl/texture.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/render_targets.h"
#include "engine/render/small_triangles.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class NamedPass {
  public:
    explicit NamedPass(const std::filesystem::path& shaders) : shaders_(shaders) {}
    /// Into the targets, which are bound, by depth.
    void draw(const SurfaceLook& look, const SmallTriangles& small, const RenderTargets& targets);

  private:
    using Programs = std::array<gl::Program, SurfaceRecords::kParts>;
    Programs& programsFor(SolidTexture texture);
    void makeMaterials(const SurfaceLook& look, const SurfaceRecords& records);
    void uploadSamples(const SmallTriangles& small, const RenderTargets& targets);
    std::filesystem::path shaders_;
    std::map<SolidTexture, Programs> programs_;  ///< of records; made when first needed
    gl::Program samples_program_;                ///< likewise
    gl::VertexArray no_attributes_;
    gl::Texture samples_, records_, materials_, normals_;
    gl::Framebuffer made_;  ///< the last two
};

}  // namespace demolish::engine
