// SPDX-License-Identifier: Apache-2.0
// The scene file of a set: its nodes as bodies and colliders, its camera and its sun.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/session/shot.h"
#include "sim_cuda/api/model_set.h"

namespace demolish {

/// How a set's file is read.
struct SetFile {
    std::string model;  ///< as the scene file is to name it
    UpAxis up = UpAxis::kY;
    std::string unit;   ///< a name of lengthUnitNames(); "": as the format says
    double metres = 1;  ///< in a length of the file
    double scale = 1;   ///< times that
};

/// How large a set is to be.
struct SetSize {
    ModelPart part;                ///< its axis and unit
    std::optional<double> height;  ///< m, from the foot of its lowest body to the top of its highest
};

/// The text of a scene (docs/file_keys.md) in which every node with triangles is a body of its own name and
/// place, `collider_...` a collider, `anchor_...` an anchor. Lifted where something would lie below the
/// floor. Throws UsageError for more colliders than there may be, and where nothing could break.
std::string sceneTextOf(const ModelSet& set, const SetFile& file);

/// Reads the set and writes its scene as one that lies at `scene_file`. Throws InputFileError; UsageError for
/// a file without a unit where no height is given, and for a height that is out of range.
std::string sceneTextOf(const std::filesystem::path& model, const SetSize& size,
                        const std::filesystem::path& scene_file);

/// The shot of that scene, without a file.
Shot splitShot(const std::filesystem::path& model, const SetSize& size);

}  // namespace demolish
