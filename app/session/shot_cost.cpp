// SPDX-License-Identifier: Apache-2.0
// Counting substeps, timing blocks, and the sentence for slow shots.
#include "app/session/shot_cost.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/session/block_timing.h"

namespace demolish {
namespace {

constexpr double kSlowFrame = 1, kSlowSettling = 10;  // s
/// s a particle and substep, more than any machine that the program was seen on has taken.
constexpr double kSlowestOnCpu = 1e-6, kSlowestOnGpu = 1e-8;

struct TimedBlock {
    double particles = 0, whole = 0, breaking = 0;  ///< s a substep
};

TimedBlock timeBlockOf(bool on_gpu, uint32_t particles) {
    const auto body = stoneBlock(particles);
    return {static_cast<double>(body->particles.size()),
            1e-6 * timeBlock(on_gpu, body, BlockState::kIntact).microseconds,
            1e-6 * timeBlock(on_gpu, body, BlockState::kShattering).microseconds};
}

/// Through two measurements; a larger block that took no longer, by chance, counts by its own rate.
SubstepTime lineThrough(double few, double few_time, double many, double many_time) {
    const double each = (many_time - few_time) / (many - few), fixed = few_time - each * few;
    if (each > 0 && fixed >= 0) return {fixed, each};
    return {0, many_time / many};
}

}  // namespace

ShotWork workOf(const Shot& shot, const SceneSetup& setup) {
    ShotWork work;
    work.bodies = static_cast<uint32_t>(setup.bodies.size());
    for (const BodyInstance& instance : setup.bodies) {
        work.particles += static_cast<uint32_t>(instance.body->particles.size());
        work.bonds += static_cast<uint32_t>(instance.body->bonds.size());
    }
    work.time_step = setup.params.frame_time / substepsOfFrame(setup.params);
    work.substeps = substepsOfFrame(setup.params, shot.time_scale);
    work.settle_substeps = static_cast<uint64_t>(std::ceil(setup.params.settle_time / work.time_step));
    work.steps_bonds = !setup.params.preset_pieces;
    return work;
}

DevicePace measurePace(bool on_gpu, uint32_t particles) {
    const TimedBlock few = timeBlockOf(on_gpu, on_gpu ? 2'000 : 500),
                     many = timeBlockOf(on_gpu, on_gpu ? std::clamp(particles, 20'000u, 100'000u) : 2'700);
    return {lineThrough(few.particles, few.whole, many.particles, many.whole),
            lineThrough(few.particles, few.breaking, many.particles, many.breaking)};
}

ShotCost costOf(const ShotWork& work, const DevicePace& pace) {
    if (!work.steps_bonds) return {};
    const double whole = pace.whole.of(work.particles), breaking = pace.breaking.of(work.particles);
    return {static_cast<double>(work.settle_substeps) * whole, 1000 * work.substeps * whole,
            1000 * work.substeps * std::max(whole, breaking)};
}

bool mayBeSlow(const ShotWork& work, bool on_gpu) {
    if (!work.steps_bonds) return false;
    const double substep = work.particles * (on_gpu ? kSlowestOnGpu : kSlowestOnCpu);
    return work.substeps * substep > kSlowFrame ||
           static_cast<double>(work.settle_substeps) * substep > kSlowSettling;
}

std::string slowNote(const ShotWork& work, const ShotCost& cost) {
    const bool slow_frames = cost.breaking_frame_ms > 1000 * kSlowFrame,
               slow_settling = cost.settle_seconds > kSlowSettling;
    if (!slow_frames && !slow_settling) return "";
    std::string note = "this shot is slow here: ";
    if (slow_settling) note += "about " + shownTime(cost.settle_seconds) + " until its bodies have settled, ";
    note += std::to_string(work.particles) + " particles in " + std::to_string(work.substeps) +
            " substeps a frame, up to about " + shownTime(cost.breaking_frame_ms / 1000) +
            " a frame while they break; faster: fewer --particles, fewer --substeps (now " +
            std::to_string(std::lround(1 / (60 * work.time_step))) +
            " per 1/60 s; less makes the bodies softer), a greater --height";
    return note;
}

std::string shownTime(double seconds) {
    const auto [unit, scale] = seconds == 0     ? std::pair("s", 1.0)
                               : seconds < 1e-3 ? std::pair("us", 1e6)
                               : seconds < 1    ? std::pair("ms", 1e3)
                                                : std::pair("s", 1.0);
    const double value = scale * seconds;
    const int decimals = value < 10 ? 1 : 0;
    char text[32];
    std::snprintf(text, sizeof text, "%.*f %s", decimals, value, unit);
    return text;
}

}  // namespace demolish
