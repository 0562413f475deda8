// SPDX-License-Identifier: Apache-2.0
#include "app/compare/method_row.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "app/bridge/host_frame.h"
#include "app/compare/crack_outlines.h"
#include "app/session/ball_flight.h"

namespace demolish {
namespace {

constexpr double kQuarterTurn = 1.5707963267948966;

FrameSummary summaryOf(std::span<const FrameSample> samples,
                       const std::function<bool(const FrameSample&)>& wanted) {
    std::vector<FrameSample> chosen;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(chosen), wanted);
    return summarise(chosen);
}

/// About the vertical, counter-clockwise seen from above.
Double3 turned(const Double3& v) {
    return {v.z, v.y, -v.x};
}

}  // namespace

void addTimes(std::span<const FrameSample> samples, std::span<const Phase> phases, MethodRow& row) {
    uint32_t broken_at_end = samples.empty() ? 0 : samples.back().stats.bonds_broken;
    const auto whole = [&](const FrameSample& frame) {
        return phases.empty() ? frame.stats.bonds_broken == 0
                              : phaseAt(phases, frame.stats.time) == &phases.front();
    };
    const auto broken = [&](const FrameSample& frame) {
        if (!phases.empty()) return phaseAt(phases, frame.stats.time) == &phases.back();
        return broken_at_end > 0 && frame.stats.bonds_broken == broken_at_end;
    };
    const FrameSummary before = summaryOf(samples, whole), after = summaryOf(samples, broken);
    row.fps_whole = before.fps_median;
    row.fps_broken = after.fps_median;
    row.sim_ms = after.sim_ms;
    row.frame_ms_worst = summarise(samples).frame_ms_worst;
}

std::vector<uint32_t> fragmentMap(Session& session) {
    std::vector<uint32_t> map = readFrame(session.solver(), FrameParts::kFragments).particle_fragment;
    map.resize(session.solver().stats().particles);  // without projectiles
    return map;
}

LineMeasure outlineOf(Session& session) {
    const HostFrame frame = readFrame(session.solver(), FrameParts::kFragments | FrameParts::kDrawLists);
    const std::vector<uint32_t> cells = cellsOfPieces(frame.particle_fragment);
    const std::span<const SurfaceVertex> outside = frame.exterior_vertices;
    const std::span<const uint32_t> fragment = frame.particle_fragment;
    std::vector<Line> lines;
    size_t vertex = 0, cell = 0;
    for (const BodyInstance& instance : session.built().setup.bodies) {
        const FractureGeometry& geometry = instance.body->geometry;
        const size_t vertices = geometry.exterior.size(), particles = instance.body->particles.size();
        for (Line& line : crackOutlines(geometry, outside.subspan(vertex, vertices),
                                        fragment.subspan(cell, particles), cells))
            lines.push_back(std::move(line));
        vertex += vertices;
        cell += particles;
    }
    return measureLines(lines, session.built().body->spacing);
}

Shot turnedImpact(const Shot& shot, const BreakableBody& body) {
    Shot other = shot;
    if (shot.impact.kind == ImpactKind::kDrop) {
        other.impact.tilt.x += kQuarterTurn;
        return other;
    }
    other.impact.direction = turned(flightDirection(shot.impact.direction, body));
    for (TimedBall& ball : other.balls)
        if (ball.direction) ball.direction = turned(flightDirection(*ball.direction, body));
    return other;
}

}  // namespace demolish
