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

#include "engine/gl/pass_clock.h"
#include "engine/render/fracture_mesh.h"
#include "engine/scene/camera.h"
#include "engine/scene/lighting.h"

namespace demolish::engine {

enum class ViewMode { kSurface, kParticles };
enum class ColourMap { kFragment, kDamage, kStress, kSpeed };

/// What a frame may cost. kFull: 2048 px shadow map, soft penumbra, ambient occlusion. kDraft: 1024 px, four
/// taps, no ambient occlusion: for software rasterisers and quick looks.
enum class RenderQuality { kFull, kDraft };

/// How the body is brought onto the picture: drawn, or, kFull and the surface only, found in compute passes.
/// The pictures differ by rounding. kAuto computes on GPUs whose driver can, and draws in software.
enum class Rasteriser { kAuto, kDraw, kCompute };

/// How the body looks; linear colours.
struct SurfaceLook {
    float exterior_colour[3] = {0.17f, 0.23f, 0.31f};
    float exterior_roughness = 0.35f;
    float interior_colour[3] = {0.60f, 0.47f, 0.34f};
    float interior_roughness = 0.9f;
    float noise_scale = 0.01f;    ///< m, first wavelength of the shading noise (0.2 h)
    float noise_strength = 0.4f;  ///< 0.3..0.5 (geometry.md 4a)
    float crack_width = 0.0015f;  ///< m
};

/// A sphere that is not part of the body (the iron ball), drawn as metal.
struct SphereDraw {
    float position[3];
    float radius;
};

struct FrameView {
    Camera camera;
    Lighting lighting;
    SurfaceLook look;
    ViewMode mode = ViewMode::kSurface;
    ColourMap colour_map = ColourMap::kFragment;
    bool show_cracks = true;
    bool show_floor = true;
    int width = 0, height = 0;  ///< px
    int samples = 4;            ///< MSAA, 1, 2 or 4; capped by what the driver offers
    RenderQuality quality = RenderQuality::kFull;
    Rasteriser rasteriser = Rasteriser::kAuto;
    float scene_radius = 1.0f;  ///< m, what the shadow map must cover
    float scene_centre[3] = {0, 0.5f, 0};
};

/// What was under a pixel.
struct Pick {
    bool hit = false;
    float position[3] = {0, 0, 0};  ///< m, world
    uint32_t fragment = 0;          ///< slot, or kFloorId
};
inline constexpr uint32_t kBackgroundId = 0xffffffffu, kFloorId = 0xfffffffeu, kSphereId = 0xfffffffdu;

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
