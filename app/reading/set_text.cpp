// SPDX-License-Identifier: Apache-2.0
// Words and numbers in lines; a name, which may hold any bytes, behind its length.
#include "app/reading/set_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/reading/mesh_stream.h"

namespace demolish {
namespace {

std::ostream& operator<<(std::ostream& out, const Double3& v) {
    return out << v.x << ' ' << v.y << ' ' << v.z << ' ';
}

class SetParser {
  public:
    explicit SetParser(const std::string& text) : in_(text) {}

    ModelSet set() {
        ModelSet set;
        const size_t count = whole(kMostThings);
        for (size_t i = 0; i < count; ++i) set.things.push_back(thing());
        if (whole(1) == 1) set.camera = camera();
        if (whole(1) == 1) set.sun = SetSun{point(), point()};
        return set;
    }

  private:
    SetCamera camera() {
        SetCamera camera{point(), point(), point(), number(), {}};
        camera.path.resize(whole(kMostCameraKeys));
        double before = 0;
        for (SetCameraKey& key : camera.path) {
            key = {number(), point(), point(), point()};
            if (!(key.time > before)) throw BrokenStream("keys of a camera are not in order");
            before = key.time;
        }
        return camera;
    }
    SetThing thing() {
        SetThing thing;
        thing.low = point();
        thing.high = point();
        thing.triangles = whole(kMostTriangles);
        thing.node.resize(whole(kMostText));
        in_.get();  // the blank
        in_.read(thing.node.data(), static_cast<std::streamsize>(thing.node.size()));
        requireGood();
        thing.motion.resize(whole(kMostPoses));
        double before = -1;
        for (SetPose& pose : thing.motion) {
            pose = {number(), point(), {number(), number(), number(), number()}};
            if (!(pose.time > before)) throw BrokenStream("poses of a thing are not in order");
            before = pose.time;
        }
        return thing;
    }
    Double3 point() {
        const double x = number(), y = number();
        return {x, y, number()};
    }
    double number() {
        double value = 0;
        in_ >> value;
        requireGood();
        if (!std::isfinite(value)) throw BrokenStream("a number is not finite");
        return value;
    }
    size_t whole(uint64_t most) {
        uint64_t value = 0;
        in_ >> value;
        requireGood();
        if (value > most) throw BrokenStream("there is too much of something");
        return static_cast<size_t>(value);
    }
    void requireGood() {
        if (!in_) throw BrokenStream("this is no set");
    }
    std::istringstream in_;
};

void writeCamera(const SetCamera& camera, std::ostream& out) {
    out << camera.eye << camera.target << camera.up << camera.field_of_view << ' ' << camera.path.size()
        << '\n';
    for (const SetCameraKey& key : camera.path)
        out << key.time << ' ' << key.eye << key.target << key.up << '\n';
}

}  // namespace

std::string setText(const ModelSet& set) {
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    const size_t count = std::min(set.things.size(), kMostThings);
    out << count << '\n';
    for (size_t i = 0; i < count; ++i) {
        const SetThing& thing = set.things[i];
        const std::string name = thing.node.substr(0, kMostText);
        out << thing.low << thing.high << thing.triangles << ' ' << name.size() << ' ' << name << ' '
            << thing.motion.size() << '\n';
        for (const SetPose& pose : thing.motion)
            out << pose.time << ' ' << pose.middle << pose.turn.x << ' ' << pose.turn.y << ' ' << pose.turn.z
                << ' ' << pose.turn.w << '\n';
    }
    out << (set.camera ? 1 : 0) << '\n';
    if (set.camera) writeCamera(*set.camera, out);
    out << (set.sun ? 1 : 0) << '\n';
    if (set.sun) out << set.sun->direction << set.sun->colour << '\n';
    return out.str();
}

ModelSet setOfText(const std::string& text) {
    return SetParser(text).set();
}

}  // namespace demolish
