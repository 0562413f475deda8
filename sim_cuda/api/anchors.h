// SPDX-License-Identifier: Apache-2.0
// What holds particles in their places, or leads them along a path: the ground about a base, the wall about a
// shelf, the hand that swings a hammer.
#pragma once
#include <optional>
#include <variant>
#include <vector>

#include "sim_cuda/api/params.h"

namespace demolish {

/// Where something is at a time, from where it was at the start.
struct PathKey {
    double time = 0;  ///< s, above 0
    Double3 way;      ///< m
    Double3 turn;     ///< rad, about x, then y, then z, through the pivot
    bool operator==(const PathKey&) const = default;
};

/// A motion that nothing stops. It begins at time 0 with no way and no turn, and stays at its last key.
struct MotionPath {
    std::vector<PathKey> keys;  ///< by ascending time; none: it stands still
    /// Between keys each number goes in a straight line; true: along a cubic whose slope at a key is the
    /// harmonic mean of those on both sides, null at the ends and where it turns back, so that it overshoots
    /// no key.
    bool smooth = false;
    bool operator==(const MotionPath&) const = default;
};
/// Where a point of what is led about `pivot` is after `time` s, m; `at`: at the start.
Double3 placeOnPath(const MotionPath& path, const Double3& pivot, const Double3& at, double time);

/// Paths of a scene at most; any number of anchors stand still.
inline constexpr uint32_t kMaxPaths = 16;

/// Holds all particles that its region reaches at the start: those with a contact sphere that lies in it, if
/// only in part. They go where its path leads them, whatever hits them, and meet no collider; their bonds
/// break as others do. Of several anchors that reach a particle the first one holds it.
struct Anchor {
    struct Everything {
        bool operator==(const Everything&) const = default;
    };
    std::variant<Everything, Box, Sphere> region;  ///< in the world, at the start
    std::optional<uint32_t> body;                  ///< of this one alone; none: of all bodies
    MotionPath path;
    Double3 pivot;  ///< m: the path turns about it, and takes it along
    bool operator==(const Anchor&) const = default;
};

}  // namespace demolish
