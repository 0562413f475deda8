// SPDX-License-Identifier: Apache-2.0
// A model file taken as a set: its things, its camera, its sun.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim_cuda/api/vectors.h"

namespace demolish {

/// Where a thing is at a time, as a rigid one.
struct SetPose {
    double time = 0;  ///< s
    Double3 middle;   ///< lengths of the file: of its box
    Quaternion turn;  ///< from how the file's triangles stand without animations
};
inline constexpr size_t kMostPoses = 1000;

/// A node with triangles, or one that its name makes a thing of its own: one whose name begins with
/// `collider_` or `anchor_` and that has no triangles stands for all below it.
struct SetThing {
    std::string node;   ///< as ModelPart's
    Double3 low, high;  ///< lengths of the file (metres where the format says its unit), round its triangles
    size_t triangles = 0;
    /// As animations move its node, by ascending time from 0 s; straight lines between. One: it stands, but
    /// not as `low` and `high` say; none: it stands.
    std::vector<SetPose> motion;
};

inline constexpr const char *kColliderPrefix = "collider_", *kAnchorPrefix = "anchor_";

struct SetCameraKey {
    double time = 0;      ///< s
    Double3 eye, target;  ///< lengths of the file; the target is a length of 1 from the eye
    Double3 up;           ///< what points up in the picture, unit, across the way that it looks
};
inline constexpr size_t kMostCameraKeys = 4800;

struct SetCamera {
    Double3 eye, target, up;   ///< as SetCameraKey's, at 0 s
    double field_of_view = 1;  ///< rad, of the picture's height
    std::vector<SetCameraKey>
        path;  ///< by ascending time, above 0 s; straight lines between; none: it stands
};

/// The first directional light.
struct SetSun {
    Double3 direction;  ///< unit, the way that the light travels
    /// Linear, what falls on a surface that faces it: of glTF lux, of other formats as they have it.
    Double3 colour;
};

struct ModelSet {
    std::vector<SetThing> things;     ///< in the file's order
    std::optional<SetCamera> camera;  ///< the first one
    std::optional<SetSun> sun;
};

/// Throws InputFileError: no plain file, unreadable, no triangles. A damaged file may still end the process,
/// as importModel() says.
ModelSet importSet(const std::filesystem::path& file);

}  // namespace demolish
