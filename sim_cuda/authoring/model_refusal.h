// SPDX-License-Identifier: Apache-2.0
// How a model is turned down: one sentence that names the file.
#pragma once
#include <cmath>
#include <filesystem>
#include <string>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/authoring/double3.h"

namespace demolish {

inline constexpr const char* kNoTriangles = "has no triangles; export it with its faces";

inline constexpr const char* kNoSuchPart =
    "names a part that is not there; the file is damaged, export it again";
inline constexpr const char* kNoSuchVertex =
    "has a face of a vertex that is not there; the file is damaged, export it again";
inline constexpr const char* kEndlessNumber =
    "has a vertex that is not a finite number; export it again without broken vertices";

/// `why` goes on from "The model 'FILE'" and has no full stop.
[[noreturn]] inline void refuseModel(const std::filesystem::path& file, const std::string& why) {
    throw InputFileError("The model '" + file.string() + "' " + why + ".");
}

inline bool isFinite(const Double3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace demolish
