// SPDX-License-Identifier: Apache-2.0
#include "app/session/scene_shapes.h"

#include <glm/gtc/quaternion.hpp>

#include "app/session/shot_geometry.h"

namespace demolish {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr Range kEdgeRange{1e-3, 1e4};  // m, radii as well

}  // namespace

void requireKey(TomlReader& reader, const std::string& path) {
    if (!reader.has(path)) reader.fail(path, "is missing");
}

Quaternion readTurn(TomlReader& reader, const std::string& at) {
    Double3 degrees;
    reader.read(at + "rotation_deg", degrees, {-360, 360});
    const glm::dquat turn(kDegree * toGlm(degrees));  // about x, then y, then z
    return {turn.x, turn.y, turn.z, turn.w};
}

Box readBox(TomlReader& reader, const std::string& at) {
    Box box;
    requireKey(reader, at + "size_m");
    reader.read(at + "size_m", box.size, kEdgeRange);
    reader.read(at + "position_m", box.position, kPlaceRange);
    box.rotation = readTurn(reader, at);
    return box;
}

Sphere readSphere(TomlReader& reader, const std::string& at) {
    Sphere ball;
    requireKey(reader, at + "radius_m");
    reader.read(at + "radius_m", ball.radius, kEdgeRange);
    reader.read(at + "position_m", ball.position, kPlaceRange);
    return ball;
}

Double3 scaled(const Double3& lengths, double by) {
    return fromGlm(by * toGlm(lengths));
}
Box scaled(const Box& box, double by) {
    return {scaled(box.size, by), scaled(box.position, by), box.rotation};
}
Sphere scaled(const Sphere& ball, double by) {
    return {by * ball.radius, scaled(ball.position, by)};
}

}  // namespace demolish
