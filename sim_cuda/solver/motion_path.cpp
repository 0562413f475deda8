// SPDX-License-Identifier: Apache-2.0
// Each of a path's six numbers is interpolated by itself.
#include "sim_cuda/solver/motion_path.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace demolish {
namespace {

using Numbers = std::array<double, 6>;

Numbers numbersOf(const PathKey& key) {
    return {key.way.x, key.way.y, key.way.z, key.turn.x, key.turn.y, key.turn.z};
}

/// Key k of a path, of which -1 is the start, and those beyond an end are as the end.
PathKey keyOf(const MotionPath& path, int64_t k) {
    if (k < 0) return {};
    return path.keys[std::min<size_t>(static_cast<size_t>(k), path.keys.size() - 1)];
}

/// Per second: of number n at key k.
double slopeAt(const MotionPath& path, int64_t k, size_t n) {
    const PathKey before = keyOf(path, k - 1), at = keyOf(path, k), after = keyOf(path, k + 1);
    if (!(at.time > before.time) || !(after.time > at.time)) return 0;  // an end
    const double in = (numbersOf(at)[n] - numbersOf(before)[n]) / (at.time - before.time),
                 out = (numbersOf(after)[n] - numbersOf(at)[n]) / (after.time - at.time);
    return in * out > 0 ? 2 * in * out / (in + out) : 0;
}

/// First key later than `time`.
size_t nextKey(const MotionPath& path, double time) {
    const auto later = std::upper_bound(path.keys.begin(), path.keys.end(), time,
                                        [](double t, const PathKey& key) { return t < key.time; });
    return static_cast<size_t>(later - path.keys.begin());
}

double between(const MotionPath& path, size_t next, size_t n, double time) {
    const auto k = static_cast<int64_t>(next);
    const PathKey a = keyOf(path, k - 1), b = keyOf(path, k);
    const double from = numbersOf(a)[n], to = numbersOf(b)[n];
    const double length = b.time - a.time, s = (time - a.time) / length;
    if (!path.smooth) return from + s * (to - from);
    const double ease = s * s * (3 - 2 * s), rest = 1 - s;
    return from + ease * (to - from) + length * s * rest * rest * slopeAt(path, k - 1, n) -
           length * s * s * rest * slopeAt(path, k, n);
}

Quat<double> aboutAxis(const Vec3<double>& axis, double angle) {
    const Vec3<double> v = std::sin(0.5 * angle) * axis;
    return {v.x, v.y, v.z, std::cos(0.5 * angle)};
}

}  // namespace

PathPose poseAt(const MotionPath& path, double time) {
    if (path.keys.empty() || !(time > 0)) return {};
    const size_t next = nextKey(path, time);
    Numbers at = numbersOf(path.keys.back());
    if (next < path.keys.size())
        for (size_t n = 0; n < at.size(); ++n) at[n] = between(path, next, n, time);
    const Quat<double> turned = multiply(aboutAxis({0, 0, 1}, at[5]),
                                         multiply(aboutAxis({0, 1, 0}, at[4]), aboutAxis({1, 0, 0}, at[3])));
    return {{at[0], at[1], at[2]}, turned};
}

Double3 placeOnPath(const MotionPath& path, const Double3& pivot, const Double3& at, double time) {
    const PathPose pose = poseAt(path, time);
    const Vec3<double> middle{pivot.x, pivot.y, pivot.z}, from{at.x, at.y, at.z};
    const Vec3<double> to = middle + pose.way + rotate(pose.turned, from - middle);
    return {to.x, to.y, to.z};
}

bool movesBetween(const MotionPath& path, double from, double to) {
    for (size_t k = 0; k < path.keys.size(); ++k) {
        const PathKey before = keyOf(path, static_cast<int64_t>(k) - 1), &at = path.keys[k];
        if (before.time < to && at.time > from && numbersOf(before) != numbersOf(at)) return true;
    }
    return false;
}

Vec3<double> turnBetween(const Quat<double>& from, const Quat<double>& to) {
    const Quat<double> turn = relativeRotation(from, to);
    const Vec3<double> v = vectorPart(turn);
    const double sine = length(v), sign = turn.w < 0 ? -1.0 : 1.0;
    if (!(sine > 0)) return {};
    return (sign * 2 * std::atan2(sine, sign * turn.w) / sine) * v;
}

}  // namespace demolish
