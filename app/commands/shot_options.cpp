// Common options to a shot.
#include "app/commands/shot_options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "app/session/scene_file.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr const char* kDefaultScene = "bunny";
// A ball of a sixth of the height must be this many times faster than the material's critical velocity to
// break the body well (the rabbit's threshold is 3.5, models.md E.2).
constexpr double kModelImpactFactor = 6;
constexpr Range kSeedRange{0, 9007199254740992.0};  // whole numbers that a double holds

double inRange(const char* option, double value, const Range& range, const char* unit) {
    requireInRange(option, value, range, unit);
    return value;
}

double wholeNumber(const char* option, double value, const Range& range) {
    requireInRange(option, value, range, "");
    if (value != std::floor(value)) throw UsageError(std::string(option) + " must be a whole number");
    return value;
}

Shot baseShot(const ShotOptions& options) {
    if (!options.scene.empty() && !options.model.empty())
        throw UsageError("give a scene name or --model, not both ('" + options.scene + "' and '" +
                         options.model + "')");
    if (options.model.empty()) return loadScene(options.scene.empty() ? kDefaultScene : options.scene);
    Shot shot;
    shot.model = options.model;
    applyMaterial(shot, shot.material_name);
    return shot;
}

void applyImpact(const ShotOptions& options, Shot& shot) {
    if (options.drop && options.impact_velocity)
        throw UsageError(
            "--drop and --impact-velocity exclude each other: a dropped body is hit by the floor");
    if (options.impact_velocity)
        shot.impact.velocity = inRange("--impact-velocity", *options.impact_velocity, kVelocityRange, "m/s");
    if (options.drop) {
        shot.impact.velocity = inRange("--drop", *options.drop, kVelocityRange, "m/s");
        shot.impact.kind = ImpactKind::kDrop;
    }
}

void applyFineness(const ShotOptions& options, Shot& shot) {
    if (options.particle_size && options.particles)
        throw UsageError("--particle-size and --particles exclude each other: one follows from the other");
    if (options.particle_size)
        shot.fineness.particle_size =
            inRange("--particle-size", *options.particle_size, kParticleSizeRange, "m");
    if (options.particles)
        shot.fineness.particles = static_cast<uint32_t>(
            wholeNumber("--particles", *options.particles, {kMinParticles, kMaxParticles}));
    if (options.quality == "draft") shot.fineness.full = shot.fineness.draft;
    if (options.quality == "full") shot.fineness.draft = shot.fineness.full;
    if (options.substeps)
        shot.substeps = static_cast<uint32_t>(wholeNumber("--substeps", *options.substeps, kSubstepRange));
    if (options.seed) shot.seed = static_cast<uint64_t>(wholeNumber("--seed", *options.seed, kSeedRange));
}

}  // namespace

void addShotOptions(CLI::App& command, ShotOptions& options) {
    command.add_option("scene", options.scene, "Scene to break (default: bunny)")->type_name("NAME");
    command.add_option("--model", options.model, "Mesh file to break instead of a scene")->type_name("FILE");
    command.add_option("--height", options.height, "Scale the model to this height (--model: 1 m)")
        ->type_name("M");
    command
        .add_option("--impact-velocity", options.impact_velocity,
                    "Speed of the iron ball; 0 = nothing hits the body")
        ->type_name("M_PER_S");
    command.add_option("--drop", options.drop, "Drop the body: it meets the floor with this speed")
        ->type_name("M_PER_S");
    command.add_option("--particle-size", options.particle_size, "Mean spacing of the particles")
        ->type_name("M");
    command.add_option("--particles", options.particles, "Number of particles, instead of their size")
        ->type_name("N");
    command.add_option("--material", options.material, "Material preset in place of the scene's")
        ->type_name("NAME");
    command.add_option("--device", options.device, "Where to simulate")
        ->type_name("auto|cpu|cuda")
        ->check(CLI::IsMember({"auto", "cpu", "cuda"}).description(""))
        ->capture_default_str();
    command.add_option("--quality", options.quality, "Fineness and picture: draft suits a CPU, full a GPU")
        ->type_name("auto|draft|full")
        ->check(CLI::IsMember({"auto", "draft", "full"}).description(""))
        ->capture_default_str();
    command
        .add_option("--substeps", options.substeps, "Substeps per 1/60 s (default: from the particle size)")
        ->type_name("N");
    command.add_option("--seed", options.seed, "Seed of packing and strengths (default 1)")->type_name("N");
    command.add_option("--fps", options.fps, "Frames per simulated second (default 60)")->type_name("N");
    command.add_option("--slow-motion", options.slow_motion, "Simulated time per frame, 0.01..1 of 1/fps")
        ->type_name("FACTOR");
    command.add_option("--size", options.size, "Picture size in pixels")->type_name("WxH");
}

Shot makeShot(const ShotOptions& options) {
    Shot shot = baseShot(options);
    if (options.height) shot.height = inRange("--height", *options.height, kHeightRange, "m");
    if (options.height && options.model.empty()) {
        shot.camera.reset();  // the scene's camera and ball suit the scene's height only
        shot.impact.ball_radius = 0;
    }
    if (!options.material.empty()) applyMaterial(shot, options.material);
    if (!options.model.empty()) shot.impact.velocity = kModelImpactFactor * shot.material.critical_velocity;
    applyImpact(options, shot);
    applyFineness(options, shot);
    if (options.fps) shot.fps = inRange("--fps", *options.fps, kFpsRange, "frames/s");
    if (options.slow_motion)
        shot.time_scale = inRange("--slow-motion", *options.slow_motion, kTimeScaleRange, "");
    shot.device = options.device == "cpu"    ? DeviceChoice::kCpu
                  : options.device == "cuda" ? DeviceChoice::kCuda
                                             : DeviceChoice::kAuto;
    return shot;
}

PictureSize pictureSize(const ShotOptions& options, PictureSize fallback) {
    if (options.size.empty()) return fallback;
    PictureSize size;
    const char* at = options.size.data();
    const char* const end = at + options.size.size();
    const auto width = std::from_chars(at, end, size.width);
    const bool crossed = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
    const auto height = crossed ? std::from_chars(width.ptr + 1, end, size.height) : width;
    const auto fits = [](int pixels) { return pixels >= 16 && pixels <= 16384; };
    if (!crossed || height.ec != std::errc{} || height.ptr != end || !fits(size.width) || !fits(size.height))
        throw UsageError("--size is '" + options.size +
                         "'; write it as 1920x1080, each side between 16 and 16384 px");
    return size;
}

engine::RenderQuality renderQuality(const ShotOptions& options, bool software_renderer) {
    if (options.quality == "draft") return engine::RenderQuality::kDraft;
    if (options.quality == "full") return engine::RenderQuality::kFull;
    return software_renderer ? engine::RenderQuality::kDraft : engine::RenderQuality::kFull;
}

}  // namespace demolish
