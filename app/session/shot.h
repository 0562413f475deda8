// SPDX-License-Identifier: Apache-2.0
// Everything that a person chooses about one shot, as plain values. The panel and the command line edit it;
// the session turns it into solver calls.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/camera_path.h"
#include "app/session/environment.h"
#include "app/session/method.h"
#include "app/session/scene_parts.h"
#include "engine/scene/camera.h"
#include "engine/scene/lens.h"
#include "engine/scene/lighting.h"
#include "engine/scene/surface_look.h"
#include "sim_cuda/api/mesh_repair.h"
#include "sim_cuda/api/model_part.h"
#include "sim_cuda/api/mortar.h"
#include "sim_cuda/api/paint.h"
#include "sim_cuda/api/params.h"

namespace demolish {

/// Whose outside bodies show.
enum class LooksOf { kFile, kMaterial };

enum class ImpactKind { kNone, kBall, kDrop };

struct Impact {
    ImpactKind kind = ImpactKind::kBall;
    uint32_t body = 0;     ///< index into Shot::bodies, that the ball hits
    double velocity = 10;  ///< m/s at the moment of impact; 0 = nothing hits the body
    /// Set: the velocity is to be so many times the one from which the body is predicted to break;
    /// chooseVelocity() puts it in and clears this.
    std::optional<double> times_threshold;
    double ball_radius = 0;      ///< m; 0 = a twelfth of the body's height (a sixth across)
    Double3 direction{0, 0, 0};  ///< the way the ball flies, any length; 0 = across the body's longer side
    /// Of the body's height, where the ball hits; none: the middle of what is seen from where it comes.
    std::optional<double> height_fraction;
    double arrival_time = 0.12;  ///< s from the start of the shot to the impact
    Double3 tilt;                ///< rad about x, y, z: how a dropped body lies in the air

    bool operator==(const Impact&) const = default;
};

/// How finely the body is divided: the first that is set counts, in this order.
struct Fineness {
    std::optional<uint32_t> particles;    ///< N
    std::optional<double> particle_size;  ///< m, h = (V / N)^(1/3)
    uint32_t full = 10000, draft = 1200;  ///< N for the GPU and for the CPU

    bool operator==(const Fineness&) const = default;
};

/// Of a bare model: it breaks well, also where the prediction is too low by its scatter.
inline constexpr double kModelTimesThreshold = 2;

enum class DeviceChoice { kAuto, kCpu, kCuda };

struct Shot {
    std::string scene = "model";       ///< name of the scene file, "model" for a bare mesh
    std::filesystem::path scene_file;  ///< empty for a bare mesh
    /// Mesh file; it and the material are those of bodies that have none of their own, of which the one that
    /// the fastest ball hits is one.
    std::filesystem::path model;
    ModelPart part;  ///< of it
    /// The same model with the paper's number of triangles, where the scene names one: benchmarks take it.
    std::optional<std::filesystem::path> paper_model;
    /// Row of assets/strength/thresholds.toml that was measured with this body; empty: the rule for any body.
    std::string strength_row;
    double height = 1.0;      ///< m; of bodies that keep their size, times that
    bool keeps_size = false;  ///< of a shot without `bodies`: as large as its file says
    RepairOptions repair;     ///< of a model that is not closed
    std::string material_name = "ceramic";
    Material material;
    std::string inner_material;  ///< whose inside the breaks show, as material_name; "": the material's own
    /// m/s: the strength is chosen so that this shot's threshold is that velocity; critical_velocity follows.
    std::optional<double> break_at;
    Impact impact;
    std::vector<SceneBody> bodies;    ///< empty: one at the origin
    std::vector<TimedBall> balls;     ///< of a ball impact, in order of time; empty: the one of `impact`
    std::vector<Phase> phases;        ///< in order of time; empty: the shot has none
    std::vector<Collider> colliders;  ///< beside the floor, in heights of the body
    std::vector<Anchor> anchors;      ///< of the scene, in the world and in heights of the body
    std::optional<Mortar> mortar;     ///< between bodies; its joint in heights of the body
    Fineness fineness;
    bool conform = false;  ///< cells follow the borders of tough cells, which are made with them
    double refine = 1;     ///< spacing farthest from where the shot is aimed over that there; 1: the same
    std::optional<PaintedStrength> painted;  ///< of models with colours at their vertices; none: only seen
    double wave_speed =
        0;  ///< m/s, c_eff to soften to at any particle size (models.md E.1); 0 = from strength
    std::optional<uint32_t> substeps;  ///< per 1/60 s; set: used as it is
    double settle_time = 0;            ///< s, at the scene's own height
    double settle_scale = 1;           ///< of that time at this height
    double scene_radius = 0;           ///< m, what flies farther ends the run; 0: as far as the bodies need
    Method method = Method::kOurs;
    /// Of preset pieces, none: usualPattern(); else of the tough cells, none: irregular.
    std::optional<Pattern> pattern;
    std::optional<Double3> pattern_axis;  ///< of tough cells; none: upright, of radial ones the shot's way
    bool hand_over = true;                ///< as SolverParams, where the method lets pieces rest
    bool sleeping = true;
    double fps = 60;        ///< frames per simulated second
    double time_scale = 1;  ///< slow motion, 0 < time_scale <= 1
    uint64_t seed = 1;
    DeviceChoice device = DeviceChoice::kAuto;

    /// `finest` follows from the fineness. Who draws nothing has no effects.
    EffectsSettings effects{.on = true};

    engine::SurfaceLook look;
    LooksOf looks = LooksOf::kFile;  ///< where the model file says something
    engine::Lighting lighting;       ///< but for what `environment` says
    Environment environment;
    std::optional<engine::Camera> camera;  ///< none: framed on the body
    std::vector<CameraKey> camera_path;    ///< of `camera`, by ascending time; empty: it stands
    engine::Lens lens;

    bool operator==(const Shot&) const = default;
};

/// Limits that the panel's sliders and the command line share.
struct Range {
    double least, most;
};
inline constexpr Range kVelocityRange{0, 200};        // m/s
inline constexpr Range kBreakAtRange{0.05, 200};      // m/s
inline constexpr Range kHeightRange{0.01, 100};       // m
inline constexpr Range kSetScaleRange{0.01, 100};     // times what files say
inline constexpr Range kThicknessRange{0, 10};        // m; 0: chosen by the sheet's area
inline constexpr Range kParticleSizeRange{1e-4, 10};  // m
inline constexpr Range kFpsRange{1, 1000};
inline constexpr Range kTimeScaleRange{0.01, 1};
inline constexpr Range kSubstepRange{1, 20000};
inline constexpr Range kAmountRange{0, 10};  // of grit, dust or sparks, times the material's
inline constexpr Range kGrainRange{1, kMaxGrains}, kPuffRange{1, kMaxPuffs};
inline constexpr Range kRefineRange{1, 4};
inline constexpr Range kPaintedLeastRange{0.01, 1};
inline constexpr Range kHourRange{5, 19};         // the sun is up
inline constexpr Range kTurnRange{-360, 360};     // degrees
inline constexpr Range kExposureRange{0.01, 20};  // times
inline constexpr Range kTemperatureRange{engine::kLeastTemperature, engine::kMostTemperature};  // K
inline constexpr Range kApertureRange{0.5, 64};                                                 // F number
inline constexpr Range kFocusRange{1e-3, 1e4};                                                  // m
inline constexpr Range kShutterRange{0, 1};                                                     // of a frame
inline constexpr Range kSamplesRange{1, 1024};      // pictures a frame
inline constexpr Range kPlaceRange{-1e4, 1e4};      // m, each coordinate of a point
inline constexpr Range kDirectionRange{-1e6, 1e6};  // each coordinate; only the way counts

/// Whole numbers in all their digits, others in six.
std::string plainNumber(double value);
/// Throws UsageError, "NAME is VALUE UNIT; it must be between A and B UNIT", also for NaN. `name` as the user
/// wrote it.
void requireInRange(const std::string& name, double value, const Range& range, const std::string& unit);
/// The same for every value of the shot.
void validate(const Shot& shot);

/// What a changed shot asks for. Each level includes the ones above it.
enum class Change {
    kNothing,
    kLive,    ///< looks, amounts of grit and dust, time scale, velocity of a ball (but takesOtherSteps())
    kSolver,  ///< material, substeps, fps, velocity of a drop: same cells, new solver
    kBody,    ///< particle size, seed, model: everything
};
Change changeBetween(const Shot& before, const Shot& after);
/// The same scene with the same mesh, however its values were changed since.
bool sameSubject(const Shot& a, const Shot& b);

}  // namespace demolish
