// SPDX-License-Identifier: Apache-2.0
// Energies and momenta of the present moment, in double.
#pragma once
#include "sim_cuda/kernels/measure_energy.h"
#include "sim_cuda/solver/checkpoint.h"
#include "sim_cuda/solver/stepper.h"

namespace demolish {

/// Owns the memory in which the state waits meanwhile.
template <class Backend, class Real>
class EnergyMeasure {
  public:
    /// Dry steps give the velocities after the next kick and what its first half dissipates; then all is put
    /// back. The contact lists must be good. decided_now: how fragments are moved has been decided for this
    /// measurement alone, and what that dissipates is part of it. Waits.
    MechanicalSums measure(DeviceScene<Backend, Real>& scene, Stepper<Backend, Real>& stepper,
                           bool decided_now);

  private:
    Checkpoint<Backend, Real> present_;
};

template <class Backend, class Real>
MechanicalSums EnergyMeasure<Backend, Real>::measure(DeviceScene<Backend, Real>& scene,
                                                     Stepper<Backend, Real>& stepper, bool decided_now) {
    auto& data = scene.data;
    const uint32_t now = data.current;
    present_.keep(scene);
    if (!decided_now) scene.backend.fill(data.ledger.span(), Vec4<Real>{});
    stepper.runDry(scene);
    const Double3 g = scene.setup.params.gravity;
    MeasureEnergy<Real> energy{
        scene.arrays(), data.particles.in(1 - now), scene.params, {g.x, g.y, g.z}, {}, {}, {}};
    energy.arrays.in = data.particles.in(now);
    if (scene.regimes.on()) {
        energy.label = scene.fragments.clusters.fragment();
        energy.regime = scene.regimes.regime();
        energy.memory = scene.regimes.bodyMemory();
    }
    const MechanicalSums sums = scene.backend.reduce(scene.tables.counts.total, MechanicalSums{}, energy,
                                                     SumInto<MechanicalSums>{}, "measure energies");
    stepper.endDry(scene);
    present_.putBack(scene);
    return sums;
}

}  // namespace demolish
