// SPDX-License-Identifier: Apache-2.0
// From a body's bonds to rows.
#include "sim_cuda/bench/floor_problem.h"

#include "sim_cuda/physics/random.h"

namespace demolish {
namespace {

constexpr double kStirring = 1e-3;  // spacings a unit of time
constexpr float kLimit = 0.5f;
constexpr double kStateBytes = 4 * sizeof(Vec4<float>);
constexpr double kSlotBytes = sizeof(uint32_t) + sizeof(FloorRest);

FloorVector scaled(const Double3& v, double scale) {
    return {static_cast<float>(scale * v.x), static_cast<float>(scale * v.y),
            static_cast<float>(scale * v.z)};
}

FloorVector stirred(uint64_t seed, uint64_t index) {
    const auto component = [&](uint64_t axis) {
        return static_cast<float>(kStirring * (2 * uniformOf(seed, 3 * index + axis) - 1));
    };
    return {component(0), component(1), component(2)};
}

}  // namespace

FloorProblem makeFloorProblem(const BreakableBody& body) {
    FloorProblem problem;
    const size_t n = body.particles.size();
    const double scale = 1 / body.spacing;
    problem.states.resize(n);
    for (size_t i = 0; i < n; ++i) {
        problem.states[i].position = scaled(body.particles[i].seed, scale);
        problem.states[i].velocity = stirred(1, i);
        problem.states[i].spin = stirred(2, i);
    }
    problem.row.assign(n + 1, 0);
    for (const auto& bond : body.bonds) {
        ++problem.row[bond.i + 1];
        ++problem.row[bond.j + 1];
    }
    for (size_t i = 0; i < n; ++i) problem.row[i + 1] += problem.row[i];
    problem.other.resize(problem.row[n]);
    problem.rest.resize(problem.row[n]);
    std::vector<uint32_t> next(problem.row.begin(), problem.row.end() - 1);
    for (const auto& bond : body.bonds) {
        const FloorVector apart = scaled(bond.normal, scale * bond.length);
        problem.other[next[bond.i]] = bond.j;
        problem.rest[next[bond.i]++] = withW(apart, kLimit);
        problem.other[next[bond.j]] = bond.i;
        problem.rest[next[bond.j]++] = withW(-apart, kLimit);
    }
    return problem;
}

void stepOnHost(FloorProblem& problem, uint32_t substeps) {
    std::vector<FloorState> before;
    for (uint32_t k = 0; k < substeps; ++k) {
        before = problem.states;
        for (size_t i = 0; i < before.size(); ++i) {
            FloorLoad load;
            for (uint32_t slot = problem.row[i]; slot < problem.row[i + 1]; ++slot) {
                FloorRest& bond = problem.rest[slot];
                if (bond.w < 0) continue;
                if (addFloorBond(before[i], before[problem.other[slot]], bond, problem.constants, load))
                    bond.w = -1;
            }
            problem.states[i] = floorMoved(before[i], load, problem.constants);
        }
    }
}

double bytesOfSubstep(size_t particles, size_t bonds) {
    return static_cast<double>(particles) * (2 * kStateBytes + sizeof(uint32_t)) +
           2 * static_cast<double>(bonds) * kSlotBytes;
}

double bytesOfSubstep(const FloorProblem& problem) {
    return bytesOfSubstep(problem.states.size(), problem.other.size() / 2);
}

}  // namespace demolish
