// SPDX-License-Identifier: Apache-2.0
// Packings made side by side, one scene of them, frames, judgement.
#include "app/breakage/batch_run.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>

#include "app/bridge/host_frame.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr uint32_t kFrames = 20;
/// m between neighbours over the largest diameter: fragments fly a fraction of it in the time simulated.
constexpr double kPitch = 4;
/// Way to the wall at the beginning, over the diameter.
constexpr double kStartGap = 1e-3;

using BodyKey = std::pair<uint32_t, uint32_t>;  ///< size, packing
using Bodies = std::map<BodyKey, std::shared_ptr<const BreakableBody>>;

void tell(const ProgressCallback& progress, double fraction, const char* stage) {
    if (progress && !progress(fraction, stage)) throw Cancelled();
}

Bodies packAll(const BreakageExperiment& experiment, const std::vector<BreakageRun>& runs,
               const ProgressCallback& progress) {
    Bodies bodies;
    for (const BreakageRun& run : runs) bodies[{run.size, run.packing}];
    std::vector<Bodies::value_type*> wanted;
    for (auto& entry : bodies) wanted.push_back(&entry);
    std::atomic<size_t> done{0};
    std::mutex telling;
    tbb::parallel_for(size_t{0}, wanted.size(), [&](size_t k) {
        const auto [size, packing] = wanted[k]->first;
        wanted[k]->second = packSphereSpecimen(specimenOf(experiment, size, packing));
        const double fraction = static_cast<double>(++done) / static_cast<double>(wanted.size());
        const std::lock_guard lock(telling);
        tell(progress, fraction, "packing specimens");
    });
    return bodies;
}

double lowestOf(const BreakableBody& body) {
    double lowest = body.particles[0].lowest;
    for (const Particle& grain : body.particles)
        lowest = std::min(lowest, grain.seed.y - grain.contact_radius);
    return lowest;
}

SolverParams paramsOf(const BreakageExperiment& experiment) {
    SolverParams params;
    params.frame_time = experiment.duration / kFrames;
    params.soften = false;
    params.step_safety = experiment.step_safety;
    params.gravity = {};
    params.contact_law = ContactLaw::kHertz;
    params.wall_friction = experiment.wall_friction;
    params.wall_stiffness = experiment.wall_stiffness;
    params.scene_radius = 1e4 * experiment.diameters[1];
    return params;
}

}  // namespace

SceneSetup sceneOf(const BreakagePlan& plan, const std::vector<BreakageRun>& runs,
                   const ProgressCallback& progress) {
    const BreakageExperiment& experiment = plan.experiments.at(runs.at(0).experiment);
    const Bodies bodies = packAll(experiment, runs, progress);
    SceneSetup setup;
    setup.params = paramsOf(experiment);
    const double pitch = kPitch * experiment.diameters[1];
    const auto columns = static_cast<size_t>(std::ceil(std::sqrt(static_cast<double>(runs.size()))));
    for (size_t k = 0; k < runs.size(); ++k) {
        const BreakageRun& run = runs[k];
        BodyInstance instance;
        instance.body = bodies.at({run.size, run.packing});
        instance.material = materialOf(experiment, run.size);
        const double height = kStartGap * experiment.diameters[run.size] - lowestOf(*instance.body);
        const double middle = static_cast<double>(columns) / 2;
        const size_t row = k / columns;
        instance.position = {pitch * (static_cast<double>(k % columns) - middle), height,
                             pitch * (static_cast<double>(row) - middle)};
        instance.velocity = {0, -run.velocity, 0};
        setup.bodies.push_back(std::move(instance));
    }
    return setup;
}

ItemResult runItem(const BreakagePlan& plan, const std::vector<BreakageRun>& runs, bool on_gpu,
                   const ProgressCallback& progress) {
    const SceneSetup setup = sceneOf(plan, runs, progress);
    const auto solver = on_gpu ? makeCudaSolver(setup, progress) : makeCpuSolver(setup, progress);
    ItemResult result;
    solver->measure();
    result.impact_energy = solver->stats().energy.kinetic;
    for (uint32_t frame = 0; frame < kFrames; ++frame) {
        const StepStatus status = solver->advanceFrame();
        if (status != StepStatus::kOk)
            throw NumericalError("the specimens' simulation became unstable; lower impact.step_safety");
        result.substeps += solver->stats().substeps;
        tell(progress, (frame + 1.0) / kFrames, "impact");
    }
    solver->measure();
    const FrameStats& stats = solver->stats();
    result.energy = stats.energy;
    result.time_step = stats.time_step;
    result.particles = stats.particles;
    result.bonds = stats.bonds;
    result.bonds_broken = stats.bonds_broken;
    const std::vector<uint32_t> fragments = readFrame(*solver, FrameParts::kFragments).particle_fragment;
    const Criteria& criteria = plan.experiments[runs[0].experiment].criteria;
    size_t first = 0;
    for (const BodyInstance& instance : setup.bodies) {
        const size_t count = instance.body->particles.size();
        result.outcomes.push_back(judge(*instance.body, {fragments.data() + first, count}, criteria));
        first += count;
    }
    return result;
}

}  // namespace demolish
