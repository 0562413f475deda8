// SPDX-License-Identifier: Apache-2.0
// Where a path leads (api/anchors.h), on the host and in double.
#pragma once
#include "sim_cuda/api/anchors.h"
#include "sim_cuda/physics/quaternion.h"

namespace demolish {

/// From the start on.
struct PathPose {
    Vec3<double> way;                 ///< m
    Quat<double> turned{0, 0, 0, 1};  ///< about the pivot
};
PathPose poseAt(const MotionPath& path, double time);

/// Does it lead anywhere between these times (s)?
bool movesBetween(const MotionPath& path, double from, double to);

/// rad: the rotation vector that takes `from` to `to`, by the shorter way.
Vec3<double> turnBetween(const Quat<double>& from, const Quat<double>& to);

}  // namespace demolish
