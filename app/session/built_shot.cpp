// SPDX-License-Identifier: Apache-2.0
// Mesh, cells, solver: one after the other, each part reused when nothing it depends on has changed.
#include "app/session/built_shot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/session/ball_flight.h"
#include "app/session/progress_part.h"
#include "app/session/shot_setup.h"
#include "app/session/threshold.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

double secondsSince(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

/// Spacings. Of drafts the large grains alone, a ninth of all: software renderers draw triangle by triangle.
constexpr double kFinestDraftGrain = 0.08;

double finestGrain(const Shot& shot, bool on_gpu) {
    const Fineness& fine = shot.fineness;
    const bool chosen = fine.particles || fine.particle_size || fine.draft == fine.full;
    return on_gpu || chosen ? kFinestGrain : kFinestDraftGrain;
}

/// Two digits, so that it reads well and is the same on every machine, whatever its pow() gives.
double twoDigits(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    return unit * std::round(value / unit);
}

}  // namespace

bool choosesCuda(const Shot& shot) {
    if (shot.device == DeviceChoice::kCpu || traitsOf(shot.method).on_cpu) return false;
    const CudaDevice device = findCudaDevice();
    if (device.usable) return true;
    if (shot.device == DeviceChoice::kAuto) return false;
    throw DeviceError("--device cuda, but " +
                      (device.problem.empty() ? "there is no usable GPU" : device.problem) +
                      "; use --device cpu or auto");
}

void chooseVelocity(Shot& shot, const BreakableBody& body) {
    const auto times = std::exchange(shot.impact.times_threshold, std::nullopt);
    const auto threshold = times ? thresholdOf(shot, body) : std::nullopt;
    if (!threshold) return;
    // A plane of 1 m only cracked at its predicted 10 m/s, and broke at 20.
    const double carried_by_floor = liesFlat(body) ? 2 : 1;
    const double breaks_from = shot.break_at.value_or(threshold->predicted),
                 velocity =
                     *times * carried_by_floor * std::max(breaks_from, shot.material.critical_velocity);
    shot.impact.velocity = std::clamp(twoDigits(velocity), kVelocityRange.least, kVelocityRange.most);
}

BuiltShot prepareShot(const Shot& shot, const BuildOptions& options, const ProgressCallback& progress) {
    const auto begun = std::chrono::steady_clock::now();
    validate(shot);
    const bool on_gpu = choosesCuda(shot);
    BuiltShot built;
    built.shot = shot;
    built.has_draw_geometry = options.draw_geometry;

    if (progress && !progress(0, "reading the model")) throw Cancelled();
    built.cells =
        makeBodyFillings(shot, on_gpu, options.draw_geometry,
                         options.reuse != nullptr ? &options.reuse->cells : nullptr, part(progress, 0, 0.75));
    built.body = built.cells.subject;
    if (shot.break_at)
        built.shot.material.critical_velocity = criticalVelocityFor(shot, *built.body, *shot.break_at);
    chooseVelocity(built.shot, *built.body);
    built.setup = makeSetup(built.shot, built.cells.of_body);
    built.setup.params.ledger = options.ledger;
    built.setup.params.effects = shot.effects;
    built.setup.params.effects.finest = finestGrain(shot, on_gpu);
    if (!options.draw_geometry) built.setup.params.effects.on = false;
    built.build_seconds = secondsSince(begun);
    return built;
}

void makeSolver(BuiltShot& built, const ProgressCallback& progress) {
    const auto begun = std::chrono::steady_clock::now();
    const ProgressCallback last_part = part(progress, 0.75, 1);
    built.solver = choosesCuda(built.shot) ? makeCudaSolver(built.setup, last_part)
                                           : makeCpuSolver(built.setup, last_part);
    built.start = built.solver->save();
    built.build_seconds += secondsSince(begun);
}

BuiltShot buildShot(const Shot& shot, const BuildOptions& options, const ProgressCallback& progress) {
    BuiltShot built = prepareShot(shot, options, progress);
    makeSolver(built, progress);
    return built;
}

}  // namespace demolish
