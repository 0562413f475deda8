// SPDX-License-Identifier: Apache-2.0
// Parts of which a scene may hold many: bodies, balls that come at their times, phases of a benchmark.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/surface_look.h"
#include "sim_cuda/api/anchors.h"
#include "sim_cuda/api/model_part.h"
#include "sim_cuda/api/params.h"
#include "sim_cuda/api/vectors.h"

namespace demolish {

/// What a body is of, and how that looks.
struct OwnMaterial {
    std::string name;
    Material material;
    engine::SurfaceLook look;
    std::string inner;  ///< name of the material whose inside `look` shows; "": its own

    bool operator==(const OwnMaterial&) const = default;
};

/// Spacing of a body's particles while bodies that say nothing about it have so many.
struct OwnSize {
    double metres = 0;
    uint32_t usual_particles = 0;

    bool operator==(const OwnSize&) const = default;
};

/// A rope or rod from a fixed place to a body, seen and not felt.
struct Cable {
    Double3 at;            ///< in the body's own frame, heights of the shot
    Double3 to;            ///< in the world, heights of the shot
    double radius = 0.01;  ///< heights of the shot
    bool operator==(const Cable&) const = default;
};

/// One body of the scene: where it stands, how it moves at the start, and what it has of its own. All else is
/// as the shot has it.
struct SceneBody {
    std::string name;      ///< "": it has none
    Double3 position;      ///< of the point that the model's origin comes to, in heights of the shot
    double yaw = 0;        ///< rad about the vertical, counter-clockwise seen from above
    uint32_t variant = 0;  ///< bodies of one variant share their cells; each variant has a seed of its own
    Quaternion turn;       ///< before the yaw
    Double3 velocity;      ///< m/s
    Double3 spin;          ///< rad/s, about its centre of mass
    std::vector<Anchor> anchors;  ///< that hold parts of it, in its own frame and in heights of the shot
    MotionPath path;              ///< of all of it, about its origin, in heights of the shot
    std::optional<Cable> cable;   ///< of a body on a path

    std::optional<std::filesystem::path> model;
    std::optional<ModelPart> part;  ///< none: all of `model`, or what the shot takes of its own
    double height_share = 1;        ///< its height, times the shot's
    bool keeps_size = false;        ///< as large as its file says, times the shot's height and this share
    std::optional<OwnMaterial> material;
    bool hidden = false, locked = false;   ///< not drawn; not to be taken hold of in the window
    bool in_mortar = true;                 ///< false: it only touches others where the scene has mortar
    bool breaks = true;                    ///< false: whole whatever hits it, rigid when nothing swings in it
    double particles_share = 1;            ///< its number of particles, times the shot's
    std::optional<OwnSize> particle_size;  ///< in place of that

    bool operator==(const SceneBody&) const = default;
};

/// A ball that hits a body at a time of its own.
struct TimedBall {
    double arrival_time = 0.12;             ///< s from the start of the shot to the impact
    double flight_time = 0.12;              ///< s before the impact in which it is there
    uint32_t body = 0;                      ///< index into Shot::bodies
    double speed_share = 1;                 ///< times Impact::velocity, so that one knob scales them all
    std::optional<double> radius;           ///< m; none: as Impact's
    std::optional<Double3> direction;       ///< in the scene, any length; none: as Impact's
    std::optional<double> height_fraction;  ///< as Impact's; none: as it says
    std::optional<Double3>
        aim;  ///< point of the body's frame to fly at, in heights of the body; none: its middle

    bool operator==(const TimedBall&) const = default;
};

/// A stretch of the shot that is timed by itself: "whole", "cracked", "some broken", "all broken".
struct Phase {
    std::string name;
    double from = 0, to = 0;  ///< s simulated; a frame belongs to it that ends in (from, to]
    double paper_fps = 0;     ///< what the paper reports for it (4.2, 4.3); 0 = nothing

    bool operator==(const Phase&) const = default;
};

}  // namespace demolish
