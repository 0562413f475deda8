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
    /// A dry substep gives the velocities after the next kick; then all is put back. The contact lists must
    /// be good. Waits.
    MechanicalSums measure(DeviceScene<Backend, Real>& scene, Stepper<Backend, Real>& stepper);

  private:
    Checkpoint<Backend, Real> present_;
};

template <class Backend, class Real>
MechanicalSums EnergyMeasure<Backend, Real>::measure(DeviceScene<Backend, Real>& scene,
                                                     Stepper<Backend, Real>& stepper) {
    present_.keep(scene);
    stepper.runDry(scene);
    present_.putBack(scene);
    const Double3 g = scene.setup.params.gravity;
    MeasureEnergy<Real> energy{scene.arrays(),
                               scene.data.particles.in(1 - scene.data.current),
                               scene.params,
                               {g.x, g.y, g.z},
                               {},
                               {},
                               {}};
    if (scene.regimes.on()) {
        energy.label = scene.fragments.clusters.fragment();
        energy.regime = scene.regimes.regime();
        energy.memory = scene.regimes.bodyMemory();
    }
    return scene.backend.reduce(scene.tables.counts.total, MechanicalSums{}, energy,
                                SumInto<MechanicalSums>{}, "measure energies");
}

}  // namespace demolish
