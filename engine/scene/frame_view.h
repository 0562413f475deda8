// SPDX-License-Identifier: Apache-2.0
// What one picture is to show, and what was found under a pixel of it: plain values.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/scene/camera.h"
#include "engine/scene/collider_draw.h"
#include "engine/scene/lighting.h"
#include "engine/scene/surface_look.h"

namespace demolish::engine {

enum class ViewMode { kSurface, kParticles };
enum class ColourMap { kFragment, kDamage, kStress, kSpeed };

/// What a frame may cost. kFull: 2048 px shadow map, soft penumbra, ambient occlusion. kDraft: 1024 px, four
/// taps, no ambient occlusion: for software rasterisers and quick looks.
enum class RenderQuality { kFull, kDraft };

/// How the body is brought onto the picture: drawn, or, kFull and the surface only, found in compute passes.
/// The pictures differ by rounding. kAuto computes on GPUs whose driver can; in software it draws, but first
/// leaves out what nothing is seen of, which is the same picture; in drafts small triangles are found on the
/// CPU, which differs by rounding.
enum class Rasteriser { kAuto, kDraw, kCompute };

/// A sphere that is not part of the body (the iron ball), drawn as metal.
struct SphereDraw {
    float position[3];
    float radius;
    bool operator==(const SphereDraw&) const = default;
};

/// When light falls on the film. Sparks are streaks of the way that they come in this time.
struct Opening {
    glm::vec2 seconds{-1.0f / 250, 0};  ///< from and to, s after the picture's moment
    glm::vec2 shares{0, 1};             ///< of the frame's whole exposure, that have passed by then
    bool operator==(const Opening&) const = default;
};

struct FrameView {
    Camera camera;
    Lighting lighting;
    SurfaceLook look;                     ///< of cells with look 0, and of grit and dust
    std::vector<SurfaceLook> more_looks;  ///< of cells with look 1, 2, ... Transparent ones are of one glass:
                                          ///< the optics of the first of them are those of all
    bool model_looks = true;              ///< the outside as the model file says, where it says something
    std::vector<ColliderDraw> colliders;  ///< at most kMostColliders are drawn
    ViewMode mode = ViewMode::kSurface;
    ColourMap colour_map = ColourMap::kFragment;
    bool show_cracks = true;
    bool show_floor = true;
    bool show_effects = true;  ///< grit and dust, of the surface view
    /// Surroundings light and are mirrored, but are not seen: alpha is 0 there. Of views with `radiance`.
    bool transparent = false;
    int width = 0, height = 0;  ///< px
    int samples = 4;            ///< MSAA, 1, 2 or 4; capped by what the driver offers
    RenderQuality quality = RenderQuality::kFull;
    Rasteriser rasteriser = Rasteriser::kAuto;
    bool radiance = false;      ///< linear light, times alpha, for a Film; the target holds RGBA16F
    glm::vec2 jitter{0};        ///< px, that the picture is moved right and up under its pixels, for a Film
    glm::vec2 lens_offset{0};   ///< m right and up, from the camera's eye to the point of the lens
    float focus_distance = 1;   ///< m along the view axis: what lies there stays in place for any lens_offset
    Opening opening;            ///< of a still a short one, however long the frame is
    float noise_turn = 0;       ///< 0..1, another for each picture that a Film averages
    float scene_radius = 1.0f;  ///< m, what the shadow map must cover
    float scene_centre[3] = {0, 0.5f, 0};

    bool hasFloor() const { return show_floor && lighting.floor != FloorMaterial::kNone; }
    bool operator==(const FrameView&) const = default;
};

/// What fits FractureMeshData::cell_looks and shows them one by one.
inline constexpr size_t kMostLooks = 32;

/// What was under a pixel.
struct Pick {
    bool hit = false;
    float position[3] = {0, 0, 0};  ///< m, world
    uint32_t fragment = 0;          ///< slot, kFloorId or kColliderId
};
inline constexpr uint32_t kBackgroundId = 0xffffffffu, kFloorId = 0xfffffffeu, kSphereId = 0xfffffffdu,
                          kColliderId = 0xfffffffcu;

}  // namespace demolish::engine
