// SPDX-License-Identifier: Apache-2.0
// Mesh, cells, solver: one after the other, each part reused when nothing it depends on has changed.
#include "app/session/built_shot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/reading/model_reader.h"
#include "app/session/ball_flight.h"
#include "app/session/shot_setup.h"
#include "app/session/threshold.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

double secondsSince(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

/// Maps a stage's own 0..1 into its share of the whole bar.
ProgressCallback part(const ProgressCallback& progress, double from, double to) {
    if (!progress) return {};
    return [&progress, from, to](double fraction, const char* stage) {
        return progress(from + (to - from) * fraction, stage);
    };
}

/// Spacings. Of drafts the large grains alone, a ninth of all: software renderers draw triangle by triangle.
constexpr double kFinestDraftGrain = 0.08;

double finestGrain(const Shot& shot, bool on_gpu) {
    const Fineness& fine = shot.fineness;
    const bool chosen = fine.particles || fine.particle_size || fine.draft == fine.full;
    return on_gpu || chosen ? kFinestGrain : kFinestDraftGrain;
}

std::vector<std::shared_ptr<const BreakableBody>> fillVariants(const Shot& shot, const SolidMesh& mesh,
                                                               uint32_t particles, bool draw_geometry,
                                                               const ProgressCallback& progress) {
    std::vector<std::shared_ptr<const BreakableBody>> variants(variantCount(shot));
    for (size_t v = 0; v < variants.size(); ++v) {
        const double share = 1.0 / static_cast<double>(variants.size()),
                     from = static_cast<double>(v) * share;
        const FillOptions fill{.particles = particles, .seed = shot.seed + v, .draw_geometry = draw_geometry};
        variants[v] = fillWithParticles(mesh, fill, part(progress, from, from + share));
    }
    return variants;
}

/// Two digits, so that it reads well and is the same on every machine, whatever its pow() gives.
double twoDigits(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    return unit * std::round(value / unit);
}

bool sameMesh(const Shot& a, const Shot& b) {
    return a.model == b.model && a.height == b.height && a.repair == b.repair;
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

uint32_t particlesWanted(const Shot& shot, const SolidMesh& mesh, bool on_gpu) {
    const uint32_t each = shot.fineness.particles       ? *shot.fineness.particles
                          : shot.fineness.particle_size ? particlesForSize(mesh, *shot.fineness.particle_size)
                          : on_gpu                      ? shot.fineness.full
                                                        : shot.fineness.draft;
    const uint64_t bodies = std::max<size_t>(1, shot.bodies.size());
    if (bodies * each > kMaxSceneParticles)
        throw UsageError(std::to_string(bodies) + " bodies of " + std::to_string(each) + " particles are " +
                         std::to_string(bodies * each) + "; at most " + std::to_string(kMaxSceneParticles) +
                         " are possible: choose at most " + std::to_string(kMaxSceneParticles / bodies) +
                         " of each body");
    return each;
}

BuiltShot prepareShot(const Shot& shot, const BuildOptions& options, const ProgressCallback& progress) {
    const auto begun = std::chrono::steady_clock::now();
    validate(shot);
    const bool on_gpu = choosesCuda(shot);
    const BuiltShot* reuse = options.reuse;
    BuiltShot built;
    built.shot = shot;
    built.has_draw_geometry = options.draw_geometry;

    if (progress && !progress(0, "reading the model")) throw Cancelled();
    built.mesh = reuse != nullptr && sameMesh(reuse->shot, shot)
                     ? reuse->mesh
                     : readSolidMesh(shot.model, placementOf(shot), part(progress, 0, 0.05));
    const uint32_t particles = particlesWanted(shot, *built.mesh, on_gpu);
    const bool same_body = reuse != nullptr && reuse->mesh == built.mesh && reuse->shot.seed == shot.seed &&
                           reuse->variants.size() == variantCount(shot) &&
                           reuse->body->particles.size() == particles &&
                           reuse->has_draw_geometry == options.draw_geometry;
    built.variants = same_body ? reuse->variants
                               : fillVariants(shot, *built.mesh, particles, options.draw_geometry,
                                              part(progress, 0.05, 0.75));
    built.body = built.variants[0];
    if (shot.break_at)
        built.shot.material.critical_velocity = criticalVelocityFor(shot, *built.body, *shot.break_at);
    chooseVelocity(built.shot, *built.body);
    built.setup = makeSetup(built.shot, built.variants);
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
