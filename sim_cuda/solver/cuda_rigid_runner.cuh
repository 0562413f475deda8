// Contact steps of rigid fragments on the GPU: two kernels each, several steps as one graph.
#pragma once
#include "sim_cuda/kernels/rigid_step_cuda.cuh"
#include "sim_cuda/solver/cuda_graph_cache.cuh"
#include "sim_cuda/solver/rigid_runner.h"

namespace demolish {

template <class Real>
class RigidRunner<CudaBackend, Real> {
  public:
    /// As on the CPU; does not wait.
    void run(CudaBackend& backend, SolverData<CudaBackend, Real>& data,
             ContactArrays<CudaBackend, Real>& contacts, const StepParams<Real>& params,
             const RigidWork& work, Span<Vec4<Real>> constants, bool ledger, uint32_t n) {
        makeRoom(backend, work);
        const SubstepArrays<Real> arrays = rigidArrays(data, contacts, Span<const Vec4<Real>>(constants));
        const Steps steps{arrays,    data.particles.out(data.current), params, work,
                          constants, data.particles.constants.view()};
        const uint32_t active = roundedUp(work.active_at_most), fragments = roundedUp(work.fragments_at_most);
        const GraphKey key{keyWord(arrays.in.position),
                           keyWord(arrays.contact_row),
                           keyWord(arrays.neighbour),
                           keyWord(arrays.contact_spring),
                           keyWord(arrays.body_laws),
                           keyWord(arrays.pair_laws),
                           keyWord(arrays.wall_laws),
                           keyWord(load_.view()),
                           keyWord(double(params.gravity.x)),
                           keyWord(double(params.gravity.y)),
                           keyWord(double(params.gravity.z)),
                           uint64_t{ledger},
                           active,
                           fragments,
                           n};
        graphs_.run(backend, key, [&] { launchAll(backend, steps, ledger, active, fragments, n); });
    }

  private:
    struct Steps {
        SubstepArrays<Real> arrays;
        StateOut<Real> state;
        StepParams<Real> params;
        RigidWork work;
        Span<Vec4<Real>> constants;
        Span<const Vec4<Real>> own_constants;
    };

    void makeRoom(CudaBackend& backend, const RigidWork& work) {
        if (load_.size() >= work.active_at_most) return;
        backend.synchronize();  // what was started before may still use it
        load_ = backend.allocate<RigidLoad<Real>>(work.active_at_most + work.active_at_most / 2);
    }

    void launchAll(CudaBackend& backend, const Steps& steps, bool ledger, uint32_t active, uint32_t fragments,
                   uint32_t n) {
        for (uint32_t done = 0; done < n;) {
            const uint32_t stride = std::min(kRigidStride, n - done);
            const StepParams<Real> params = rigidParams(steps.params, stride);
            ledger ? launch<true>(backend.stream(), steps, params, active, fragments)
                   : launch<false>(backend.stream(), steps, params, active, fragments);
            checkCuda(cudaGetLastError(), "starting a contact step");
            done += stride;
        }
    }

    template <bool kLedger>
    void launch(cudaStream_t stream, const Steps& steps, const StepParams<Real>& params, uint32_t active,
                uint32_t fragments) {
        constexpr uint32_t kParticles = kSubstepBlock / kLoadThreads;
        if (steps.work.active_at_most > 0)
            rigidLoadKernel<kLedger, Real>
                <<<(active + kParticles - 1) / kParticles, kSubstepBlock, 0, stream>>>(
                    steps.arrays, params, steps.work, load_.span());
        rigidStepKernel<kLedger, Real><<<fragments, kRigidLanes, 0, stream>>>(
            StepRigid<kLedger, Real>{steps.arrays, steps.state, params, steps.work, load_.view(),
                                     steps.constants, steps.own_constants});
    }

    CudaBackend::Buffer<RigidLoad<Real>> load_;
    CudaGraphCache graphs_;
};

}  // namespace demolish
