// SPDX-License-Identifier: Apache-2.0
// The shot of the scene "bunny" at few particles. Not part of a test run: pictures must not depend on the
// solver.
#include "tests/render/rabbit_record.h"

#include <cstdio>
#include <memory>
#include <set>
#include <stdexcept>

#include "sim_cuda/api/solver.h"
#include "tests/render/rabbit_replay.h"

namespace demolish::engine::test {
namespace {

struct Shot {
    const char* name;
    double speed;  // m/s
    int frames;
};

std::unique_ptr<Solver> makeSolver(double speed) {
    SceneSetup setup;
    BodyInstance rabbit;
    rabbit.body = rabbitBody();
    rabbit.material.tough_cells = 20;
    setup.bodies.push_back(rabbit);
    setup.params.substeps = 160;
    Projectile ball;
    ball.radius = 0.0275;
    ball.position = {0.22, 0.14, 0.19};
    ball.velocity = {-0.75 * speed, 0, -0.66 * speed};
    setup.projectiles.push_back(ball);
    return makeCpuSolver(setup);
}

RabbitState stateOf(Solver& solver, const StreamSizes& sizes) {
    const size_t particles = rabbitBody()->particles.size();
    std::vector<uint32_t> slots(particles), indices(sizes.interior_indices);
    std::vector<CrackLine> cracks(sizes.crack_edges);
    std::vector<FragmentTransform> transforms(particles);
    std::vector<SurfaceVertex> vertices(sizes.interior_vertices);
    DrawCommands commands{};
    RenderStreams streams;
    streams.particle_fragment = {slots.data(), slots.size()};
    streams.transforms = {transforms.data(), transforms.size()};
    streams.interior_vertices = {vertices.data(), vertices.size()};
    streams.interior_indices = {indices.data(), indices.size()};
    streams.crack_edges = {cracks.data(), cracks.size()};
    streams.commands = {&commands, 1};
    solver.exportFrame(streams, true);
    RabbitState state;
    cracks.resize(commands.cracks.instance_count);
    state.slot = slots;
    state.cracks = cracks;
    for (const uint32_t slot : slots) state.transform[slot] = transforms[slot];
    return state;
}

void record(const Shot& shot) {
    const auto solver = makeSolver(shot.speed);
    SceneSetup sized;
    sized.bodies.push_back({});
    sized.bodies[0].body = rabbitBody();
    for (int frame = 0; frame < shot.frames; ++frame) {
        if (solver->advanceFrame() != StepStatus::kOk) throw std::runtime_error("The solver gave up");
    }
    const RabbitState state = stateOf(*solver, streamSizes(sized));
    writeState(stateFile(shot.name), state);
    std::printf("%s: %zu fragments, %zu crack edges\n", shot.name, state.transform.size(),
                state.cracks.size());
}

}  // namespace

void recordStates() {
    for (const Shot& shot : {Shot{"cracked", 6, 12}, Shot{"broken", 16, 14}}) record(shot);
}

}  // namespace demolish::engine::test
