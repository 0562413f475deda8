// SPDX-License-Identifier: Apache-2.0
// Runs the search for pairs on the GPU.
#pragma once
#include "sim_cuda/backend/cuda_backend.cuh"
#include "sim_cuda/kernels/find_pairs_cuda.cuh"
#include "sim_cuda/solver/pair_finder.h"

namespace demolish {

template <class Real>
struct PairFinder<CudaBackend, Real> {
    static void find(CudaBackend& backend, const NeighbourSearch<Real>& search, const RowDrafts& drafts,
                     const ProjectileBits& projectiles) {
        const uint32_t warps = searchWarps(search.in_bodies, search.total - search.in_bodies);
        backend.launch(true, findPairsKernel<Real>, (warps + kSearchWarps - 1) / kSearchWarps, kSearchBlock,
                       "find pairs", search, drafts, projectiles);
    }
};

}  // namespace demolish
