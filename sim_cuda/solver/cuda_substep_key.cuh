// SPDX-License-Identifier: Apache-2.0
// What every kind of step writes into a graph.
#pragma once
#include "sim_cuda/kernels/step_params.h"
#include "sim_cuda/solver/cuda_graph_cache.cuh"

namespace demolish {

template <class Real>
GraphKey stepKey(const SubstepArrays<Real>& arrays, const StepParams<Real>& params, bool ledger) {
    return {keyWord(arrays.in.position),       keyWord(arrays.constants),
            keyWord(arrays.contact_row),       keyWord(arrays.neighbour),
            keyWord(arrays.contact_spring),    keyWord(arrays.body_laws),
            keyWord(arrays.pair_laws),         keyWord(arrays.wall_laws),
            keyWord(double(params.gravity.x)), keyWord(double(params.gravity.y)),
            keyWord(double(params.gravity.z)), uint64_t{ledger}};
}

}  // namespace demolish
