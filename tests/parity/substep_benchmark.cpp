// Microseconds of one substep, by size, threads a particle and ledger: a falling brick with 12 bonds a
// particle.
//   substep_benchmark [cpu|cuda] [particles ...]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "sim_cuda/api/solver.h"
#include "tests/physics/solver/lattice_body.h"

namespace demolish::tests {
namespace {

/// The brick's bonds and three of the face diagonals: 12 slots a particle inside.
std::shared_ptr<const BreakableBody> denseBrick(uint32_t n, double h) {
    auto body = std::make_shared<BreakableBody>(*latticeBody(n, n, n, h, 0.1));
    const auto id = [&](uint32_t x, uint32_t y, uint32_t z) { return (z * n + y) * n + x; };
    const auto bond = [&](uint32_t i, uint32_t j) {
        const Double3 a = body->particles[i].seed, b = body->particles[j].seed;
        const Double3 d{b.x - a.x, b.y - a.y, b.z - a.z};
        const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        body->bonds.push_back({i, j, 0.2 * h * h, {}, {d.x / length, d.y / length, d.z / length}, length});
    };
    for (uint32_t z = 0; z < n; ++z)
        for (uint32_t y = 0; y < n; ++y)
            for (uint32_t x = 0; x < n; ++x) {
                if (x + 1 < n && y + 1 < n) bond(id(x, y, z), id(x + 1, y + 1, z));
                if (y + 1 < n && z + 1 < n) bond(id(x, y, z), id(x, y + 1, z + 1));
                if (x + 1 < n && z + 1 < n) bond(id(x, y, z), id(x + 1, y, z + 1));
            }
    std::sort(body->bonds.begin(), body->bonds.end(), [](const BondGeometry& a, const BondGeometry& b) {
        return a.i != b.i ? a.i < b.i : a.j < b.j;
    });
    return body;
}

struct Timing {
    double microseconds = 0;
    uint32_t rebuilds = 0;
};

Timing timeOne(Solver& solver, uint32_t substeps) {
    std::vector<double> times;
    Timing timing;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const auto start = std::chrono::steady_clock::now();
        if (solver.advanceSubsteps(substeps) != StepStatus::kOk) std::printf("step failed\n");
        solver.synchronize();
        times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() *
                        1e6 / substeps);
        timing.rebuilds += solver.stats().list_rebuilds;
    }
    std::sort(times.begin(), times.end());
    timing.microseconds = times[times.size() / 2];
    return timing;
}

void benchmark(bool cuda, uint32_t particles, bool ledger, bool hit, const char* threads) {
    setenv("DEMOLISH_THREADS_PER_PARTICLE", threads, 1);
    const auto n = static_cast<uint32_t>(std::lround(std::cbrt(static_cast<double>(particles))));
    SceneSetup setup = freeBody(denseBrick(n, 1.0 / n));
    setup.params.ledger = ledger;
    setup.params.planes.push_back(Plane{});
    setup.bodies[0].position = {0, hit ? 0.001 : 1.0, 0};
    setup.bodies[0].velocity = {0, hit ? -4.0 : 0.0, 0};
    auto solver = cuda ? makeCudaSolver(setup) : makeCpuSolver(setup);
    const uint32_t substeps = cuda ? (particles < 100'000 ? 1000 : 200) : 20;
    solver->advanceSubsteps(substeps);
    const Timing timing = timeOne(*solver, substeps);
    std::printf("%8u particles %9u bonds  T %-4s ledger %d  %s  %9.2f us/substep  broken %u  rebuilds %u\n",
                n * n * n, solver->stats().bonds, threads, ledger, hit ? "breaking" : "falling ",
                timing.microseconds, solver->stats().bonds_broken, timing.rebuilds);
    std::fflush(stdout);
}

}  // namespace
}  // namespace demolish::tests

int main(int count, char** arguments) {
    const bool cuda = count > 1 && std::strcmp(arguments[1], "cuda") == 0;
    std::vector<uint32_t> sizes;
    for (int k = 2; k < count; ++k) sizes.push_back(static_cast<uint32_t>(std::atoi(arguments[k])));
    if (sizes.empty()) sizes = {2'000, 10'000, 50'000};
    const std::vector<const char*> threads =
        cuda ? std::vector<const char*>{"1", "2", "4", "8", "16"} : std::vector<const char*>{"-"};
    for (const uint32_t particles : sizes) {
        for (const char* wish : threads) demolish::tests::benchmark(cuda, particles, false, false, wish);
        demolish::tests::benchmark(cuda, particles, true, false, "-");
        demolish::tests::benchmark(cuda, particles, false, true, "-");
    }
}
