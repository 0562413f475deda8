// SPDX-License-Identifier: Apache-2.0
// Time of a rebuild after the particle size has changed: glmark2's bunny, or a model file given as argument.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/packing.h"
#include "sim_cuda/authoring/solid_checks.h"
#include "tests/unit/cells/complex_checks.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {
namespace {

struct Model {
    explicit Model(const std::filesystem::path& file)
        : mesh(importTriangles(file)), queries(mesh), grid(mesh, queries), volume(signedVolume(mesh)) {
        grid.insideNodesInMortonOrder();
    }
    std::vector<Double3> pack(uint32_t count) const {
        return packSeeds(mesh, queries, grid, evenSpacing(volume, count), count, 1);
    }

    TriangleMesh mesh;
    MeshQueries queries;
    DistanceGrid grid;
    double volume;
};

void pack(benchmark::State& state, const Model& model) {
    for (auto _ : state) benchmark::DoNotOptimize(model.pack(uint32_t(state.range(0))));
}

void cells(benchmark::State& state, const Model& model) {
    const uint32_t count = uint32_t(state.range(0));
    const std::vector<Double3> seeds = model.pack(count);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            buildCellComplex(model.mesh, model.queries, seeds, spacingOf(model.mesh, count), 1));
}

void packCellsMassesBonds(benchmark::State& state, const Model& model) {
    const uint32_t count = uint32_t(state.range(0));
    const double spacing = spacingOf(model.mesh, count);
    for (auto _ : state) {
        const CellComplex complex =
            buildCellComplex(model.mesh, model.queries, model.pack(count), spacing, 1);
        benchmark::DoNotOptimize(massProperties(model.mesh, model.queries, complex));
        benchmark::DoNotOptimize(makeBonds(complex, spacing));
    }
}

void registerAll(const Model& model) {
    const auto add = [&](const char* name, void (*function)(benchmark::State&, const Model&)) {
        benchmark::RegisterBenchmark(name,
                                     [&model, function](benchmark::State& state) { function(state, model); })
            ->Arg(1000)
            ->Arg(5000)
            ->Arg(20000)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime();
    };
    add("pack", pack);
    add("cells", cells);
    add("pack_cells_masses_bonds", packCellsMassesBonds);
}

}  // namespace
}  // namespace demolish::test

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const demolish::test::Model model(argc > 1 ? argv[1] : "/usr/share/glmark2/models/bunny.obj");
    demolish::test::registerAll(model);
    benchmark::RunSpecifiedBenchmarks();
}
