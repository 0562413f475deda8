// SPDX-License-Identifier: Apache-2.0
// Common options to a shot.
#include "app/commands/shot_options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "app/commands/model_options.h"
#include "app/commands/option_values.h"
#include "app/commands/particle_options.h"
#include "app/session/model_shot.h"
#include "app/session/scene_file.h"
#include "app/session/set_scene.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kPiecesRange{0, 100000};
constexpr const char* kDefaultScene = "bunny";
Shot baseShot(const ShotOptions& options) {
    if (!options.scene.empty() && !options.model.empty())
        throw UsageError("give a scene name or --model, not both ('" + options.scene + "' and '" +
                         options.model + "')");
    if (options.split && options.model.empty())
        throw UsageError("--split is for --model: it makes a scene of the nodes of a file");
    if (options.model.empty()) return loadScene(options.scene.empty() ? kDefaultScene : options.scene);
    if (options.split) return splitShot(options.model, setSize(options));
    return modelShot(options.model);
}

void applyImpact(const ShotOptions& options, Shot& shot) {
    if (options.drop && options.impact_velocity)
        throw UsageError(
            "--drop and --impact-velocity exclude each other: a dropped body is hit by the floor");
    if (options.drop || options.impact_velocity) shot.impact.times_threshold.reset();
    if (options.impact_velocity)
        shot.impact.velocity = inRange("--impact-velocity", *options.impact_velocity, kVelocityRange, "m/s");
    if (options.drop) {
        shot.impact.velocity = inRange("--drop", *options.drop, kVelocityRange, "m/s");
        shot.impact.kind = ImpactKind::kDrop;
    }
    if (options.break_at) shot.break_at = inRange("--break-at", *options.break_at, kBreakAtRange, "m/s");
}

/// The scene's camera suits the scene's height only, its balls grow with the body, and what weight takes to
/// settle goes with the root of the height, as all that falls.
void applyHeight(double height, bool is_scene, Shot& shot) {
    for (const SceneBody& body : shot.bodies)
        if (body.keeps_size)
            throw UsageError("--height is for bodies that are scaled to one, and some of scene '" +
                             shot.scene + "' are as large as their files say; change them in " +
                             shot.scene_file.string());
    const double ratio = height / shot.height;
    shot.height = height;
    shot.keeps_size = false;
    if (!is_scene) return;
    shot.settle_scale = std::sqrt(ratio);
    shot.camera.reset();
    shot.camera_path.clear();
    shot.impact.ball_radius = 0;
    for (TimedBall& ball : shot.balls)
        if (ball.radius) *ball.radius *= ratio;
}

void applySize(const ShotOptions& options, Shot& shot) {
    if (options.split) return;  // the set was scaled as a whole
    requireOneSize(options);
    if (options.height)
        applyHeight(inRange("--height", *options.height, kHeightRange, "m"), options.model.empty(), shot);
    if (!options.unit.empty()) setUnit(shot, shot.part.unit);
}

/// Benchmarks take the paper's mesh where there is one; a person who asks for it is told when there is none.
void applyMesh(const ShotOptions& options, const std::string& fallback, Shot& shot) {
    if (!options.mesh.empty() && !options.model.empty())
        throw UsageError("--mesh chooses between the meshes of a scene; leave it out with --model");
    if (options.mesh == "paper" && !shot.paper_model)
        throw UsageError("scene '" + shot.scene + "' has one mesh only; leave out --mesh paper");
    if ((options.mesh.empty() ? fallback : options.mesh) == "paper" && shot.paper_model)
        shot.model = *shot.paper_model;
}

/// Bodies of a scene say themselves which part of a model they are.
void applyPart(const ShotOptions& options, Shot& shot) {
    if (options.node.empty() && options.up.empty() && options.unit.empty()) return;
    if (options.model.empty())
        throw UsageError("--node, --up and --unit are for --model; scene files have keys of these names");
    if (options.split && !options.node.empty())
        throw UsageError("--split takes all nodes of the file, and --node one of them; choose");
    if (!options.split) shot.part = modelPart(options);
}

void applyRepair(const ShotOptions& options, Shot& shot) {
    if (!options.repair.empty()) shot.repair.mode = repairModeOf(options.repair).value_or(RepairMode::kAuto);
    if (options.thickness)
        shot.repair.thickness = inRange("--thickness", *options.thickness, kThicknessRange, "m");
}

/// A body's own material is the file's business; pieces are a matter of all bodies.
void applyMaterialOptions(const ShotOptions& options, Shot& shot) {
    if (!options.material.empty() || !options.inner_material.empty()) {
        for (const SceneBody& body : shot.bodies)
            if (body.material)
                throw UsageError(
                    "--material and --inner-material are for scenes of one material, and bodies of scene '" +
                    shot.scene + "' have their own; change them in " + shot.scene_file.string());
        applyMaterials(shot, options.material.empty() ? shot.material_name : options.material,
                       options.inner_material.empty() ? shot.inner_material : options.inner_material);
    }
    if (!options.pieces) return;
    const auto pieces = static_cast<uint32_t>(wholeNumber("--pieces", *options.pieces, kPiecesRange));
    shot.material.tough_cells = pieces;
    for (SceneBody& body : shot.bodies)
        if (body.material) body.material->material.tough_cells = pieces;
}

void applyEffects(const ShotOptions& options, Shot& shot) {
    if (!options.effects.empty()) shot.effects.on = options.effects == "on";
    if (options.grit) shot.effects.grit = inRange("--grit", *options.grit, kAmountRange, "");
    if (options.sparks) shot.effects.sparks = inRange("--sparks", *options.sparks, kAmountRange, "");
    if (options.dust) shot.effects.dust = inRange("--dust", *options.dust, kAmountRange, "");
}

Double3 axisOf(const std::vector<double>& values) {
    for (const double value : values) requireInRange("--pattern-axis", value, kDirectionRange, "");
    const Double3 axis{values[0], values[1], values[2]};
    if (axis == Double3{}) throw UsageError("--pattern-axis is 0,0,0, which points nowhere");
    return axis;
}

/// Preset pieces move as rigid bodies; heavy physics never lets anything rest.
void applyMethod(const ShotOptions& options, Shot& shot) {
    if (const auto method = methodOf(options.method)) shot.method = *method;
    if (const auto pattern = patternOf(options.pattern)) shot.pattern = pattern;
    const MethodTraits& method = traitsOf(shot.method);
    const std::string name = std::string("method ") + methodName(shot.method);
    if (!options.pattern_axis.empty()) {
        if (method.pattern_turns || !shot.pattern)
            throw UsageError("--pattern-axis is for tough cells of a --pattern, and not for " + name);
        shot.pattern_axis = axisOf(options.pattern_axis);
    }
    if (method.pattern_turns && options.no_hand_over)
        throw UsageError(name + " steps no bonds; leave out --no-hand-over");
    if (method.on_cpu && options.device == "cuda")
        throw UsageError(name + " runs on the CPU; leave out --device cuda");
    shot.hand_over = !options.no_hand_over;
    shot.sleeping = !options.no_sleep;
}

void addMethodOptions(CLI::App& command, ShotOptions& options) {
    command
        .add_option("--method", options.method,
                    "How it breaks: by bonds (ours; heavy: all of them all the time; cores: on the CPU), or "
                    "into preset pieces")
        ->type_name("NAME")
        ->check(CLI::IsMember(methodNames()).description(""));
    command
        .add_option("--pattern", options.pattern,
                    "Of tough cells or preset pieces: uniform, radial, slabs, bricks or splinters; --pieces "
                    "says how many")
        ->type_name("NAME")
        ->check(CLI::IsMember(patternNames()).description(""));
    command
        .add_option("--pattern-axis", options.pattern_axis,
                    "Of a pattern of tough cells (upright; of radial ones the shot's way)")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3);
}

void addEffectOptions(CLI::App& command, ShotOptions& options) {
    command.add_option("--effects", options.effects, "Grit, dust and sparks where bodies break (bench: off)")
        ->type_name("on|off")
        ->check(CLI::IsMember({"on", "off"}).description(""));
    command.add_option("--grit", options.grit, "Times as much grit as the material says, 0..10")
        ->type_name("FACTOR");
    command.add_option("--dust", options.dust, "Times as much dust as the material says, 0..10")
        ->type_name("FACTOR");
    command.add_option("--sparks", options.sparks, "Times as many sparks as the material says, 0..10")
        ->type_name("FACTOR");
}

void addMaterialOptions(CLI::App& command, ShotOptions& options) {
    command
        .add_option("--material", options.material, "Material in place of the scene's: a preset, or a file")
        ->type_name("NAME|FILE.toml");
    command
        .add_option("--inner-material", options.inner_material,
                    "Breaks show the inside of this material, whatever the body is made of")
        ->type_name("NAME|FILE.toml");
    command
        .add_option("--looks", options.looks,
                    "The outside as the model file says where it says something, or as the material")
        ->type_name("file|material")
        ->check(CLI::IsMember({"file", "material"}).description(""));
}

}  // namespace

void addShotOptions(CLI::App& command, ShotOptions& options) {
    const std::string own_group = command.get_help_ptr()->get_group();
    command.add_option("scene", options.scene, "Scene to break, or a scene file of yours (default: bunny)")
        ->type_name("NAME|FILE.toml");
    command.add_option("--model", options.model, "Mesh file to break instead of a scene")->type_name("FILE");
    command
        .add_option("--height", options.height,
                    "Scale the model to this height (--model: the file's size, or 1 m where it says no unit)")
        ->type_name("M");
    addModelOptions(command, options);
    command.add_flag("--split", options.split,
                     "Of --model: each node of the file is a body; collider_... nodes stand fixed");
    command
        .add_option("--impact-velocity", options.impact_velocity,
                    "Speed of the fastest ball, the others in proportion; 0 = nothing hits the body")
        ->type_name("M_PER_S");
    command.add_option("--drop", options.drop, "Drop the body: it meets the floor with this speed")
        ->type_name("M_PER_S");
    command
        .add_option("--break-at", options.break_at,
                    "Choose the strength so that the shot breaks the body from this velocity on")
        ->type_name("M_PER_S");
    command
        .add_option("--mesh", options.mesh,
                    "The scene's smooth mesh, or the one with the paper's number of triangles")
        ->type_name("fine|paper")
        ->check(CLI::IsMember({"fine", "paper"}).description(""));
    addParticleOptions(command, options);
    addMaterialOptions(command, options);
    command.add_option("--device", options.device, "Where to simulate; auto: on the GPU if there is one")
        ->type_name("auto|cpu|cuda")
        ->check(CLI::IsMember({"auto", "cpu", "cuda"}).description(""))
        ->capture_default_str();
    command.add_option("--quality", options.quality, "Fineness and picture: draft suits a CPU, full a GPU")
        ->type_name("auto|draft|full")
        ->check(CLI::IsMember({"auto", "draft", "full"}).description(""))
        ->capture_default_str();
    command.add_option("--fps", options.fps, "Frames per simulated second (default: 60)")->type_name("N");
    command.add_option("--slow-motion", options.slow_motion, "Simulated time per frame, 0.01..1 of 1/fps")
        ->type_name("FACTOR");
    addMethodOptions(command, options);
    command.add_flag("--no-hand-over", options.no_hand_over,
                     "Step bonds even in pieces that no longer vibrate");
    command.add_flag("--no-sleep", options.no_sleep, "Step what rests, too");
    addEffectOptions(command, options);
    command.add_option("--size", options.size, "Picture size in pixels, such as 1280x720")->type_name("WxH");
    addPictureOptions(command, options.picture);
    for (CLI::Option* option : command.get_options())
        if (option->nonpositional() && option->get_group() == own_group && option != command.get_help_ptr())
            option->group("What to break, and how");
}

Shot makeShot(const ShotOptions& options, const std::string& mesh) {
    Shot shot = baseShot(options);
    applyMesh(options, mesh, shot);
    applyPart(options, shot);
    applySize(options, shot);
    applyRepair(options, shot);
    applyMaterialOptions(options, shot);
    if (!options.looks.empty()) shot.looks = options.looks == "file" ? LooksOf::kFile : LooksOf::kMaterial;
    applyEffects(options, shot);
    applyMethod(options, shot);
    applyImpact(options, shot);
    applyParticles(options, shot);
    if (options.fps) shot.fps = inRange("--fps", *options.fps, kFpsRange, "frames/s");
    if (options.slow_motion)
        shot.time_scale = inRange("--slow-motion", *options.slow_motion, kTimeScaleRange, "");
    shot.device = deviceChoice(options);
    applyPicture(options.picture, shot);
    return shot;
}

DeviceChoice deviceChoice(const ShotOptions& options) {
    return options.device == "cpu"    ? DeviceChoice::kCpu
           : options.device == "cuda" ? DeviceChoice::kCuda
                                      : DeviceChoice::kAuto;
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
    if (!options.picture.look.empty())
        return options.picture.look == "draft" ? engine::RenderQuality::kDraft : engine::RenderQuality::kFull;
    if (options.quality == "draft") return engine::RenderQuality::kDraft;
    if (options.quality == "full") return engine::RenderQuality::kFull;
    return software_renderer ? engine::RenderQuality::kDraft : engine::RenderQuality::kFull;
}

int windowSamples(bool software_renderer) {
    return software_renderer ? 2 : 4;
}

const char* qualityName(engine::RenderQuality quality) {
    return quality == engine::RenderQuality::kDraft ? "draft" : "full";
}

}  // namespace demolish
