// Contact steps of rigid fragments. How they run depends on the backend: here the CPU, for CUDA see
// cuda_rigid_runner.cuh.
#pragma once
#include "sim_cuda/backend/cpu_backend.h"
#include "sim_cuda/kernels/rigid_step.h"
#include "sim_cuda/solver/solver_data.h"

namespace demolish {

/// Substeps of bonds in one contact step of rigid fragments: their contacts are as soft as heavy, and need no
/// stress waves.
inline constexpr uint32_t kRigidStride = 10;

/// What a contact step of `stride` substeps changes in the constants of a substep.
template <class Real>
StepParams<Real> rigidParams(StepParams<Real> params, uint32_t stride) {
    params.dt = static_cast<Real>(stride) * params.dt;
    const double dt = static_cast<double>(params.dt);
    params.stiffness_cap = params.face_cap = static_cast<Real>(kContactStiffnessShare / (dt * dt));
    params.softening = 1;
    return params;
}

/// The arrays of a substep as contact steps use them: other constants, and both instants of the state kept
/// the same.
template <class Backend, class Real>
SubstepArrays<Real> rigidArrays(SolverData<Backend, Real>& data, ContactArrays<Backend, Real>& contacts,
                                Span<const Vec4<Real>> constants) {
    SubstepArrays<Real> arrays = data.arrays(contacts);
    arrays.constants = constants;
    return arrays;
}

template <class Backend, class Real>
class RigidRunner;

template <class Real>
class RigidRunner<CpuBackend, Real> {
  public:
    /// n substeps' time, in contact steps of kRigidStride substeps and a shorter last one.
    void run(CpuBackend& backend, SolverData<CpuBackend, Real>& data,
             ContactArrays<CpuBackend, Real>& contacts, const StepParams<Real>& params, const RigidWork& work,
             Span<Vec4<Real>> constants, bool ledger, uint32_t n) {
        if (load_.size() < work.active_at_most)
            load_ = backend.allocate<RigidLoad<Real>>(work.active_at_most + work.active_at_most / 2);
        const SubstepArrays<Real> arrays = rigidArrays(data, contacts, Span<const Vec4<Real>>(constants));
        for (uint32_t done = 0; done < n;) {
            const uint32_t stride = std::min(kRigidStride, n - done);
            const StepParams<Real> step = rigidParams(params, stride);
            ledger ? runOne<true>(backend, data, arrays, step, work, constants)
                   : runOne<false>(backend, data, arrays, step, work, constants);
            done += stride;
        }
    }

  private:
    template <bool kLedger>
    void runOne(CpuBackend& backend, SolverData<CpuBackend, Real>& data, const SubstepArrays<Real>& arrays,
                const StepParams<Real>& params, const RigidWork& work, Span<Vec4<Real>> constants) {
        backend.forEach(work.active_at_most,
                        GatherRigidLoad<kLedger, Real>{arrays, params, work, load_.span()}, "rigid load");
        backend.forEach(work.fragments_at_most,
                        StepRigid<kLedger, Real>{arrays, data.particles.out(data.current), params, work,
                                                 load_.view(), constants, data.particles.constants.view()},
                        "rigid step");
    }

    CpuBackend::Buffer<RigidLoad<Real>> load_;
};

}  // namespace demolish
