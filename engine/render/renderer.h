// SPDX-License-Identifier: Apache-2.0
// Draws one frame of a shot into the current framebuffer: the list of passes, in order.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/gl/pass_time.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class FractureMesh;

class Renderer {
  public:
    /// `shader_folder` holds the GLSL files. `raster_tasks`: for how many squares of 16 px of large
    /// triangles (52 bytes each) Rasteriser::kCompute has memory; where they do not suffice it goes slower.
    /// Throws GlError with the file and the compiler's message.
    explicit Renderer(const std::filesystem::path& shader_folder, size_t raster_tasks = size_t{1} << 20);
    ~Renderer();

    /// Draws into `target_framebuffer` (0: the window) of size view.width x view.height.
    void draw(const FractureMesh* mesh, std::span<const SphereDraw> spheres, const FrameView& view,
              unsigned target_framebuffer = 0);

    /// Fragment slot, world position under a pixel (origin top left); draws an id pass.
    Pick pick(const FractureMesh* mesh, std::span<const SphereDraw> spheres, const FrameView& view, int x,
              int y);
    /// Id of every pixel, row by row from the top; for tests that hold on every driver.
    std::vector<uint32_t> fragmentIds(const FractureMesh* mesh, std::span<const SphereDraw> spheres,
                                      const FrameView& view);

    /// GPU time of the last finished draw, ms (time stamps; lags by a few frames).
    double lastDrawMs() const;
    /// The same, pass by pass. Valid until the next call of draw, lastDrawMs or lastPassTimes.
    std::span<const gl::PassTime> lastPassTimes() const;

    /// Why the driver refused to compute the picture, which is drawn since then, and slower; empty: it did
    /// not.
    const std::string& refusal() const;

  private:
    struct Passes;
    std::unique_ptr<Passes> passes_;
};

}  // namespace demolish::engine
