// SPDX-License-Identifier: Apache-2.0
// Lists of a scene file, checked element by element.
#include "app/session/scene_parts_file.h"

#include <algorithm>

#include "app/session/shot_geometry.h"

namespace demolish {
namespace {

constexpr Range kTimeRange{0, 1000};        // s
constexpr Range kArrivalRange{0.01, 1000};  // s
constexpr Range kFlightRange{0.01, 2};      // s

std::string element(const char* list, size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "].";
}

template <class Value>
void readOptional(TomlReader& reader, const std::string& path, std::optional<Value>& value,
                  const Range& range) {
    if (!reader.has(path)) return;
    value.emplace();
    reader.read(path, *value, range);
}

TimedBall readBall(TomlReader& reader, const std::string& at, const BodiesOfFile& bodies, double& velocity) {
    TimedBall ball;
    for (const char* key : {"at_s", "velocity_mps"})
        if (!reader.has(at + key)) reader.fail(at + key, "is missing");
    reader.read(at + "at_s", ball.arrival_time, kArrivalRange);
    ball.flight_time = std::min(ball.flight_time, ball.arrival_time);
    reader.read(at + "flight_s", ball.flight_time, kFlightRange);
    if (ball.flight_time > ball.arrival_time) reader.fail(at + "flight_s", "must not be longer than at_s");
    reader.read(at + "velocity_mps", velocity, {0.01, kVelocityRange.most});
    reader.read(at + "body", ball.body, {0, static_cast<double>(bodies.count - 1)});
    readOptional(reader, at + "radius_m", ball.radius, {1e-4, 100});
    readOptional(reader, at + "height_fraction", ball.height_fraction, {0, 1});
    if (reader.has(at + "direction")) {
        ball.direction.emplace();
        reader.read(at + "direction", *ball.direction, kDirectionRange);
    }
    if (reader.has(at + "aim_m")) {
        Double3 metres;
        reader.read(at + "aim_m", metres, kPlaceRange);
        ball.aim = fromGlm(toGlm(metres) / bodies.height);
    }
    return ball;
}

}  // namespace

std::vector<TimedBall> readBalls(TomlReader& reader, const BodiesOfFile& bodies, Impact& impact) {
    std::vector<TimedBall> balls(reader.count("ball", kMaxProjectiles));
    std::vector<double> velocity(balls.size());
    for (size_t i = 0; i < balls.size(); ++i)
        balls[i] = readBall(reader, element("ball", i), bodies, velocity[i]);
    if (balls.empty()) return balls;
    if (!reader.has("impact.velocity_mps"))
        impact.velocity = *std::max_element(velocity.begin(), velocity.end());
    if (!(impact.velocity > 0)) reader.fail("impact.velocity_mps", "must be above 0 in a scene with balls");
    for (size_t i = 0; i < balls.size(); ++i) balls[i].speed_share = velocity[i] / impact.velocity;
    std::stable_sort(balls.begin(), balls.end(),
                     [](const TimedBall& a, const TimedBall& b) { return a.arrival_time < b.arrival_time; });
    return balls;
}

std::vector<Phase> readPhases(TomlReader& reader) {
    constexpr double kMostPhases = 100;
    std::vector<Phase> phases(reader.count("phase", kMostPhases));
    for (size_t i = 0; i < phases.size(); ++i) {
        const std::string at = element("phase", i);
        Phase& phase = phases[i];
        reader.read(at + "name", phase.name);
        reader.read(at + "from_s", phase.from, kTimeRange);
        reader.read(at + "to_s", phase.to, kTimeRange);
        reader.read(at + "paper_fps", phase.paper_fps, {0, 1e6});
        if (phase.name.empty()) reader.fail(at + "name", "is missing");
        if (!(phase.to > phase.from)) reader.fail(at + "to_s", "must be later than from_s");
        if (i > 0 && phase.from < phases[i - 1].to)
            reader.fail(at + "from_s", "must not lie before the end of the phase before it");
    }
    return phases;
}

}  // namespace demolish
