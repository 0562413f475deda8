// SPDX-License-Identifier: Apache-2.0
// A body of parts that lie apart: cells hold several of them, and its fragments are many before anything
// breaks.
#include <gtest/gtest.h>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/model_file.h"
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/api/stats.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {
namespace {

SceneSetup cubesApart() {
    constexpr int kAlong = 20;
    constexpr double kApart = 1.5;  // m
    TriangleMesh cubes;
    for (int i = 0; i < kAlong * kAlong; ++i)
        cubes = joined(cubes, makeCube(1), {kApart * (i % kAlong), 0, kApart * (i / kAlong)});
    MeshPlacement placement;
    placement.keep_units = true;
    const auto solid = makeSolidMesh(std::move(cubes), "cubes.obj", placement, nullptr);
    SceneSetup setup;
    setup.bodies.emplace_back();
    setup.bodies[0].body = fillWithParticles(*solid, {.particles = 200});
    return setup;
}

struct Lists {
    DrawCommands commands{};
    std::vector<CrackLine> lines;

    Lists(Solver& solver, size_t edges) : lines(edges, CrackLine{0xffffffffu, 0}) {
        RenderStreams streams;
        streams.commands = {&commands, 1};
        streams.crack_edges = {lines.data(), lines.size()};
        solver.exportFrame(streams, true);
    }
};

TEST(PartsApart, APutBackStartIsDrawnAsTheStart) {
    const SceneSetup setup = cubesApart();
    const size_t edges = streamSizes(setup).crack_edges;
    ASSERT_GT(edges, 0u);
    auto solver = makeCpuSolver(setup);
    EXPECT_GT(solver->stats().fragments, 1u);
    const Lists start(*solver, edges);
    solver->restore(solver->save());
    const Lists again(*solver, edges);
    EXPECT_EQ(again.commands.cracks.instance_count, start.commands.cracks.instance_count);
    EXPECT_EQ(again.commands.interior.count, start.commands.interior.count);
    EXPECT_EQ(again.commands.exterior.count, start.commands.exterior.count);
    for (uint32_t line = 0; line < again.commands.cracks.instance_count; ++line)
        EXPECT_LT(again.lines[line].edge, edges) << "drawn, but not written";
}

}  // namespace
}  // namespace demolish::test
