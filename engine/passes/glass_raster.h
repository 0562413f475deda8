// SPDX-License-Identifier: Apache-2.0
// Finds the faces of transparent bodies along each ray in compute passes: all at once, in the order of their
// depths, instead of drawing everything once for each of them.
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "engine/passes/triangle_raster.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

class GlassRaster {
  public:
    /// Faces that a ray keeps: one more than are walked through, since two may lie in one.
    static constexpr int kKept = 5;
    /// Of the sun's view, along.
    static constexpr int kSumTexels = 1024;
    static constexpr GLuint kSumLevels = 4;

    /// `task_room`: as TriangleRaster's. Throws GlError.
    GlassRaster(const std::filesystem::path& shaders, size_t task_room);

    /// Has the driver storage enough for this picture of this mesh? `across`: rays along a pixel.
    static bool suits(const FractureMesh& mesh, const RenderTargets& targets, int across);
    /// Of the text that reads the faces (shaders/common/faces.glsl).
    static std::string defines(int across);
    /// Makes the shaders, which find() would do otherwise. Throws GlError.
    void prepare(const RenderTargets& targets, int across);

    /// Faces before the depth of `targets`; `hidden_looks`: kHiddenLooks.
    void find(const FractureMesh& mesh, const RenderTargets& targets, int across, uint32_t hidden_looks);
    /// Adds up what these bodies take from the sun (shaders/common/glass_tint.glsl) into RG32F `sums`,
    /// kSumTexels along and kSumLevels deep, and the ends of its way (shaders/common/glass_ends.glsl) into
    /// `ends`, which is like it. `scattered`: by a broken face, minus the logarithm of what is left.
    void castSums(const FractureMesh& mesh, uint32_t hidden_looks, float scattered, const gl::Texture& sums,
                  const gl::Texture& ends);
    /// For a pass that reads the faces. It leaves them empty (forgetFaces()).
    void bind(const FractureMesh& mesh) const;

  private:
    static size_t words(const RenderTargets& targets, int across);

    std::filesystem::path shaders_;
    TriangleRaster triangles_;
    std::map<std::pair<int, int>, TriangleRaster::Programs> programs_;  ///< by samples, and rays across
    TriangleRaster::Programs casting_;  ///< these and the next: made by prepare()
    gl::Program show_sums_;
    gl::Buffer faces_, sums_;
};

}  // namespace demolish::engine
