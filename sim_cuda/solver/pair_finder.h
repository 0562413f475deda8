// SPDX-License-Identifier: Apache-2.0
// Runs the search for pairs: how depends on the backend, here the CPU; for CUDA see cuda_pair_finder.cuh.
#pragma once
#include "sim_cuda/backend/cpu_backend.h"
#include "sim_cuda/kernels/find_pairs.h"

namespace demolish {

/// find(backend, search, drafts, projectiles): fills drafts and bits, which are 0 before. Does not wait.
template <class Backend, class Real>
struct PairFinder;

template <class Real>
struct PairFinder<CpuBackend, Real> {
    static void find(CpuBackend& backend, const NeighbourSearch<Real>& search, const RowDrafts& drafts,
                     const ProjectileBits& projectiles) {
        backend.forEach(search.total, FindPairs<Real>{search, drafts, projectiles}, "find pairs");
    }
};

}  // namespace demolish
