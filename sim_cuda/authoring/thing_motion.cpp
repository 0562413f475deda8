// SPDX-License-Identifier: Apache-2.0
// A thing is read where its node stands without animations, and taken from there to where they have it.
#include "sim_cuda/authoring/thing_motion.h"

#include "sim_cuda/authoring/key_thinning.h"
#include "sim_cuda/authoring/model_refusal.h"
#include "sim_cuda/authoring/node_motion.h"

namespace demolish {
namespace {

constexpr double kPlaceError = 1e-3;  // of how large the thing is, or how far it goes
constexpr double kStands = 1e-5;      // likewise: nearer than that is where it was

Double3 turned(const Quaternion& q, const Double3& v) {
    const Double3 axis{q.x, q.y, q.z}, across = cross(axis, v) * 2;
    return v + across * q.w + cross(axis, across);
}

/// The rotation that takes a place to another; what is left of it where it also stretches.
Quaternion turnBetween(const NodeTransform& from, const NodeTransform& to) {
    const Double3 yz = cross(from.y, from.z), zx = cross(from.z, from.x), xy = cross(from.x, from.y);
    const double by = 1 / from.determinant();
    const Double3 x = normalized(to.direction(Double3{yz.x, zx.x, xy.x} * by)),
                  second = to.direction(Double3{yz.y, zx.y, xy.y} * by),
                  y = normalized(second - x * dot(x, second)), z = cross(x, y);
    const auto real = [](double value) { return static_cast<ai_real>(value); };
    const aiQuaternion q(aiMatrix3x3(real(x.x), real(y.x), real(z.x), real(x.y), real(y.y), real(z.y),
                                     real(x.z), real(y.z), real(z.z)));
    const double length =
        std::sqrt(double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z + double(q.w) * q.w);
    return {q.x / length, q.y / length, q.z / length, q.w / length};
}

bool isSound(const SetPose& pose) {
    return isFinite(pose.middle) && isFinite({pose.turn.x, pose.turn.y, pose.turn.z});
}

/// Middle and three points as far from it as the thing reaches.
std::vector<Double3> pointsOf(const SetPose& pose, double reach) {
    std::vector<Double3> points{pose.middle};
    for (const Double3& axis : {Double3{reach, 0, 0}, {0, reach, 0}, {0, 0, reach}})
        points.push_back(pose.middle + turned(pose.turn, axis));
    return points;
}

double farthest(const std::vector<Double3>& from, const std::vector<Double3>& to) {
    double most = 0;
    for (size_t i = 0; i < from.size(); ++i) most = std::max(most, length(to[i] - from[i]));
    return most;
}

/// `reach`: from the middle.
std::vector<SetPose> thinned(const std::vector<SetPose>& poses, double reach) {
    std::vector<std::vector<Double3>> points;
    std::vector<double> times;
    double way = 2 * reach;
    for (const SetPose& pose : poses) {
        times.push_back(pose.time);
        points.push_back(pointsOf(pose, reach));
        way = std::max(way, farthest(points.front(), points.back()));
    }
    for (std::vector<Double3>& list : points)
        for (Double3& p : list) p = p * (1 / (kPlaceError * way));
    std::vector<SetPose> kept;
    for (const size_t k : neededMoments(times, points)) kept.push_back(poses[k]);
    const double went = kPlaceError * way * farthest(points.front(), points.back());
    if (kept.size() == 2 && went < kStands * way) kept.pop_back();
    return kept;
}

}  // namespace

std::vector<SetPose> motionOf(const aiScene& scene, const aiNode& node, const SetThing& thing) {
    if (!scene.HasAnimations()) return {};
    const NodeMotion motion(scene, node);
    const NodeTransform stands = placeOf(node);
    const double reach = 0.5 * length(thing.high - thing.low);
    if (motion.times().empty() || !(std::abs(stands.determinant()) > 0) || !(reach > 0)) return {};
    const SetPose start{0, (thing.low + thing.high) * 0.5, {}};
    std::vector<SetPose> poses;
    for (const double time : looksAt(motion.times(), kMostPoses - 2)) {
        const NodeTransform there = motion.at(time);
        const Quaternion turn = turnBetween(stands, there);
        const SetPose pose{time, there.origin + turned(turn, start.middle - stands.origin), turn};
        if (isSound(pose)) poses.push_back(pose);
    }
    if (poses.empty() || poses.front().time > 0) return {};
    poses = thinned(poses, reach);
    const bool as_read =
        poses.size() == 1 && farthest(pointsOf(start, reach), pointsOf(poses[0], reach)) < kStands * reach;
    return as_read ? std::vector<SetPose>{} : poses;
}

}  // namespace demolish
