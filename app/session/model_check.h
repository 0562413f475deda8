// SPDX-License-Identifier: Apache-2.0
// What a model file holds, what was done to close it, and whether it will break: said before anything is
// simulated.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/session/built_shot.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/model_file.h"

namespace demolish {

struct ModelCheck {
    std::string file;
    ModelContents contents;
    std::shared_ptr<const ModelLooks> looks;  ///< null: the file says nothing of them
    Double3 size_in_file;                     ///< m where the format says its unit, else units of the file
    double unit = 0;          ///< m, as chosen for a format that does not say it; 0: not known
    std::string size_remark;  ///< as sizeRemark()
    RepairReport repair;
    SolidMeshInfo solid;     ///< as it stands; of the mesh that was filled
    double thin_wall = 0;    ///< m: a fiftieth of the surface lies over thinner walls
    uint32_t particles = 0;  ///< 0: there is no body
    double spacing = 0;      ///< m
    uint32_t open_cells = 0;
    double velocity = 0;  ///< m/s, of the ball that such a shot begins with
    std::string refusal;  ///< why it will not break, a sentence; "": it will
};

/// Reads the shot's model, closes it, cuts it into cells and throws them away. What is wrong with the file is
/// in ModelCheck::refusal; throws only UsageError, DeviceError and Cancelled.
ModelCheck checkModel(const Shot& shot, const ProgressCallback& progress = {});

/// The same of a body that is made already, for the window.
ModelCheck checkOf(const BuiltShot& built);

/// A label and what is to be said, a line each.
using LabelledLines = std::vector<std::pair<std::string, std::string>>;
LabelledLines checkLines(const ModelCheck& check);
nlohmann::ordered_json checkJson(const ModelCheck& check);

}  // namespace demolish
