// SPDX-License-Identifier: Apache-2.0
// Runs substeps on the CPU.
#pragma once
#include "sim_cuda/backend/cpu_backend.h"
#include "sim_cuda/kernels/substep_cpu.h"
#include "sim_cuda/solver/substep_runner.h"

namespace demolish {

template <class Real>
class SubstepRunner<CpuBackend, Real> {
  public:
    explicit SubstepRunner(CpuBackend&) {}

    /// n substeps from data.current on, which turns with each of them.
    void run(CpuBackend& backend, SolverData<CpuBackend, Real>& data,
             ContactArrays<CpuBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
             uint32_t n, bool = false) {
        for (uint32_t k = 0; k < n; ++k) runOne(backend, data, contacts, params, ledger);
    }
    void runOne(CpuBackend& backend, SolverData<CpuBackend, Real>& data,
                ContactArrays<CpuBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
                bool = false) {
        ledger ? runWith<true>(backend, data, contacts, params)
               : runWith<false>(backend, data, contacts, params);
        data.current = 1 - data.current;
    }
    void runOn(CpuBackend& backend, SolverData<CpuBackend, Real>& data,
               ContactArrays<CpuBackend, Real>& contacts, const StepParams<Real>& params, bool ledger,
               uint32_t n) {
        run(backend, data, contacts, params, ledger, n, true);
    }

  private:
    template <bool kLedger>
    void runWith(CpuBackend& backend, SolverData<CpuBackend, Real>& data,
                 ContactArrays<CpuBackend, Real>& contacts, const StepParams<Real>& params) {
        const size_t slots = data.bonds.link.size();
        if (record_.size() != slots) record_ = backend.allocate<BondRecord<Real>>(slots);
        if (kLedger && damping_.size() != slots) damping_ = backend.allocate<DampingRecord<Real>>(slots);
        const SubstepArrays<Real> arrays = data.arraysInSubsteps(contacts);
        const BondPairs<Real> pairs{data.bonds.slot_of_bond.view(), data.bonds.twin.view(), record_.span(),
                                    damping_.span()};
        const BondedWork& work = data.work;
        const CpuParticleStep<kLedger, Real> step(arrays, params, pairs);
        backend.forRanges(work.all() ? data.bonds.count : work.bonds.count, [&](size_t first, size_t last) {
            BondLanes<kLedger, Real>(arrays, params, pairs).evaluate(first, last);
        });
        backend.forEach(
            work.all() ? params.in_bodies : work.at_most,
            [&](uint32_t k) { step(work.all() ? k : work.ids[k]); }, "substep");
        for (uint32_t p = params.in_bodies; p < params.total; ++p)
            if (work.movesProjectile(p)) step(p);
    }

    CpuBackend::Buffer<BondRecord<Real>> record_;
    CpuBackend::Buffer<DampingRecord<Real>> damping_;
};

}  // namespace demolish
