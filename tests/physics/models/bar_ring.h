// SPDX-License-Identifier: Apache-2.0
// The ringing of a bar on either device; bar_wave.h says what it is.
#pragma once
#include <cmath>
#include <vector>

#include "sim_cuda/physics/time_step.h"
#include "sim_cuda/solver/device_solver.h"
#include "tests/physics/models/bar_wave.h"

namespace demolish::tests {

/// m/s, at the ends: single precision needs strains well above its own.
template <class Real>
inline constexpr double kRingSpeed = sizeof(Real) == sizeof(float) ? 1e-2 : 1e-4;

template <class Backend, class Real>
BarWave ringBarOn(const SceneSetup& setup, SceneTables tables, const Vec3<double>& axis, double length) {
    const uint32_t count = tables.counts.in_bodies;
    double mass = 0, middle = 0;
    for (uint32_t i = 0; i < count; ++i) {
        mass += tables.mass[i];
        middle += tables.mass[i] * dot(axis, tables.position[i]);
    }
    std::vector<double> shape(count);
    for (uint32_t i = 0; i < count; ++i) {
        shape[i] = std::sin(kPi * (dot(axis, tables.position[i]) - middle / mass) / length);
        tables.velocity[i] = (kRingSpeed<Real> * shape[i]) * axis;
    }
    const double omega = highestFrequency(tables, 0, count, tables.body[0].shear_ratio) / 1.01;
    Backend backend;
    SolverData<Backend, Real> data(backend, tables, 0);
    LawTables laws = buildLawTables(setup, tables, {});
    laws.body[0].beta_r = 0;
    data.uploadLaws(backend, laws);
    NeighbourLists<Backend, Real> lists(backend, tables.counts, tables.largest_radius);
    StepParams<Real> params = makeStepParams<Real>(setup.params, tables);
    const double dt = 0.5 * criticalStep(omega);
    params.dt = static_cast<Real>(dt);
    params.breaking = 0;
    SubstepRunner<Backend, Real> runner(backend);
    constexpr int kCrossings = 5;  // two periods
    double previous = 1, first = 0, last = 0;
    int crossings = 0;
    for (int step = 1; crossings < kCrossings && step < 200'000; ++step) {
        runner.run(backend, data, lists.contacts(), params, false, 1);
        const auto velocity = backend.downloaded(data.particles.in(data.current).velocity);
        double amplitude = 0;
        for (uint32_t i = 0; i < count; ++i)
            amplitude += tables.mass[i] * shape[i] * dot(axis, asDouble(xyz(velocity[i])));
        if ((amplitude > 0) != (previous > 0)) {
            last = (step - amplitude / (amplitude - previous)) * dt;
            if (++crossings == 1) first = last;
        }
        previous = amplitude;
    }
    const double period = 2 * (last - first) / (kCrossings - 1);
    return {2 * length / period, criticalStep(omega)};
}

}  // namespace demolish::tests
