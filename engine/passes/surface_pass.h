// SPDX-License-Identifier: Apache-2.0
// Draws the body: outside and broken faces, each with its material.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "engine/gl/program.h"
#include "engine/passes/body_geometry.h"
#include "engine/passes/named_pass.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/seen_mesh.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

/// Sets the uniforms of shaders/common/body_material.glsl, which begin at `location`.
void setBodyMaterial(gl::Program& program, GLint location, const SurfaceLook& look);
/// Of bodies whose outside is not the material's: their broken faces show no rim of it.
SurfaceLook withoutCoat(SurfaceLook look);
/// Which texture such a shader is made for.
std::string textureDefine(SolidTexture texture);

class SurfacePass {
  public:
    explicit SurfacePass(const std::filesystem::path& shaders);
    /// Everything that is not transparent. `with_looks`: the outside as its model file says.
    /// `near` as in BodyGeometry; `seen`: no more of the mesh than this, null: all. Into `targets`, which are
    /// bound.
    void draw(BodyGeometry& body, const FractureMesh& mesh, const FrameView& view, bool with_looks,
              const NearFaces* near, const SeenMesh* seen, const RenderTargets& targets);

  private:
    struct Programs {
        gl::Program exterior, interior;
    };
    Programs& programsFor(SolidTexture texture, bool with_looks);
    std::filesystem::path shaders_;
    NamedPass named_;
    std::map<std::pair<SolidTexture, bool>, Programs> programs_;  ///< made when first needed
};

}  // namespace demolish::engine
