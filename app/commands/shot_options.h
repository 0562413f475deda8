// SPDX-License-Identifier: Apache-2.0
// The options that view, capture and bench have in common.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/picture_options.h"
#include "app/session/shot.h"
#include "engine/scene/frame_view.h"

namespace CLI {
class App;
}

namespace demolish {

struct PictureSize {
    int width = 0, height = 0;  ///< px
};

struct ShotOptions {
    std::string scene, model, device = "auto", material, inner_material, looks, quality = "auto", size;
    std::optional<double> height, drop, impact_velocity, break_at, particle_size, fps, slow_motion;
    std::optional<double> particles, seed, substeps,
        pieces;                  ///< whole numbers, checked when the shot is made
    std::string node, up, unit;  ///< "" = the scene's, or all of the file, y, and as the format says
    std::string repair;          ///< "" = the scene's
    std::optional<double> thickness;
    std::string mesh;  ///< "fine" or "paper"; "" = the command's own
    PictureOptions picture;
    std::string method, pattern;  ///< "" = the scene's
    bool split = false;
    std::vector<double> pattern_axis;
    std::string conform;  ///< "on" or "off"; "" = the scene's
    std::optional<double> refine, painted_least;
    std::string painted;  ///< "" = the scene's
    bool no_hand_over = false, no_sleep = false;
    std::string effects;  ///< "on" or "off"; "" = the command's own
    std::optional<double> grit, dust, sparks;
};

void addShotOptions(CLI::App& command, ShotOptions& options);

/// `mesh` ("fine" or "paper") counts where the options name none. Throws UsageError (ranges, unknown scene,
/// options that exclude each other) and the errors of scene files.
Shot makeShot(const ShotOptions& options, const std::string& mesh = "fine");

/// --device.
DeviceChoice deviceChoice(const ShotOptions& options);

/// "1280x720". Throws UsageError; `fallback` if the option was not given.
PictureSize pictureSize(const ShotOptions& options, PictureSize fallback);

/// --look, --quality, or draft for a software rasteriser.
engine::RenderQuality renderQuality(const ShotOptions& options, bool software_renderer);
/// Samples a pixel of the window, which bench times; software renderers feel each of them.
int windowSamples(bool software_renderer);
const char* qualityName(engine::RenderQuality quality);

}  // namespace demolish
