// SPDX-License-Identifier: Apache-2.0
// Names and ranges are those of a scene's keys.
#include "app/commands/picture_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr const char* kGroup = "Light and camera";
constexpr uint32_t kFinalPictures = 64;

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
    return text;
}

double inRange(const std::string& name, double value, const Range& range, const std::string& unit) {
    requireInRange(name, value, range, unit);
    return value;
}

/// The word's place in the list; CLI11 has checked that it is there.
size_t placeOf(const std::string& word, const std::vector<std::string>& words) {
    return static_cast<size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

void applyEnvironment(const PictureOptions& options, Environment& environment) {
    if (!options.environment.empty()) setEnvironment(environment, options.environment);
    if (options.environment_turn)
        environment.turn = inRange("--environment-turn", *options.environment_turn, kTurnRange, "degrees");
    if (options.hour) environment.hour = inRange("--hour", *options.hour, kHourRange, "h");
    if (options.hour && environment.kind != engine::SurroundingsKind::kSky)
        throw UsageError("--hour places the sun of a clear sky; leave it out, or give --environment sky");
    if (options.environment_turn && environment.kind != engine::SurroundingsKind::kFile)
        throw UsageError("--environment-turn turns the picture of a file; give one by --environment");
}

}  // namespace

void addPictureOptions(CLI::App& command, PictureOptions& options) {
    command
        .add_option(
            "--environment", options.environment,
            "Surroundings that light the scene and are mirrored: sky, studio, overcast, or a picture of "
            "all directions (.hdr, .exr), whose sun casts the shadows")
        ->type_name("NAME|FILE")
        ->group(kGroup);
    command
        .add_option("--environment-turn", options.environment_turn,
                    "Turn a file's picture about the vertical")
        ->type_name("DEGREES")
        ->group(kGroup);
    command.add_option("--hour", options.hour, "Of the sun in a clear sky, 5 to 19")
        ->type_name("H")
        ->group(kGroup);
    command
        .add_option("--floor", options.floor, "What the floor is made of; shadow: only its shadows are seen")
        ->type_name(joined(floorNames()))
        ->check(CLI::IsMember(floorNames()).description(""))
        ->group(kGroup);
    command.add_option("--exposure", options.exposure, "Brightness of the picture (the scenes': 0.85)")
        ->type_name("FACTOR")
        ->group(kGroup);
    command
        .add_option("--white-balance", options.white_balance,
                    "Colour temperature of the light shown as white (6500)")
        ->type_name("KELVIN")
        ->group(kGroup);
    command.add_option("--tone", options.tone, "Curve from light to display")
        ->type_name(joined(toneNames()))
        ->check(CLI::IsMember(toneNames()).description(""))
        ->group(kGroup);
    command
        .add_option(
            "--look", options.look,
            "Picture alone: draft and preview as --quality draft and full have it; final also takes time for "
            "soft edges and shadows in captures")
        ->type_name("draft|preview|final")
        ->check(CLI::IsMember({"draft", "preview", "final"}).description(""))
        ->group(kGroup);
    command
        .add_option(
            "--aperture", options.aperture,
            "F number of a full-frame lens: what is out of focus blurs; in the window while it is paused")
        ->type_name("F")
        ->group(kGroup);
    command.add_option("--focus", options.focus, "Distance that is in focus (the camera's target)")
        ->type_name("M")
        ->group(kGroup);
}

void addFilmOptions(CLI::App& command, FilmOptions& options) {
    command
        .add_option("--shutter", options.shutter,
                    "Share of a frame for which the shutter is open, 0 to 1: blurs what moves (0)")
        ->type_name("SHARE")
        ->group(kGroup);
    command
        .add_option(
            "--samples", options.samples,
            "Pictures that a frame is averaged of (16 with --shutter or --aperture, 64 with --look final)")
        ->type_name("N")
        ->group(kGroup);
    command
        .add_flag("--transparent", options.transparent,
                  "Nothing behind the scene: PNG with straight alpha; with --floor shadow for compositing")
        ->group(kGroup);
}

void applyFilm(const FilmOptions& options, const std::string& look, Shot& shot) {
    if (look == "final") shot.lens.samples = kFinalPictures;
    if (options.shutter)
        shot.lens.shutter =
            static_cast<float>(inRange("--shutter", *options.shutter, kShutterRange, "of a frame"));
    if (!options.samples) return;
    const double samples = inRange("--samples", *options.samples, kSamplesRange, "");
    if (samples != std::floor(samples)) throw UsageError("--samples must be a whole number");
    shot.lens.samples = static_cast<uint32_t>(samples);
}

void applyPicture(const PictureOptions& options, Shot& shot) {
    applyEnvironment(options, shot.environment);
    engine::Lighting& light = shot.lighting;
    if (!options.floor.empty())
        light.floor = static_cast<engine::FloorMaterial>(placeOf(options.floor, floorNames()));
    if (!options.tone.empty())
        light.tone = static_cast<engine::ToneCurve>(placeOf(options.tone, toneNames()));
    if (options.exposure)
        light.exposure = static_cast<float>(inRange("--exposure", *options.exposure, kExposureRange, ""));
    if (options.white_balance)
        light.temperature =
            static_cast<float>(inRange("--white-balance", *options.white_balance, kTemperatureRange, "K"));
    if (options.aperture)
        shot.lens.aperture = static_cast<float>(inRange("--aperture", *options.aperture, kApertureRange, ""));
    if (options.focus)
        shot.lens.focus = static_cast<float>(inRange("--focus", *options.focus, kFocusRange, "m"));
    if (shot.environment.kind == engine::SurroundingsKind::kFile) litBy(shot.environment, light);
}

}  // namespace demolish
