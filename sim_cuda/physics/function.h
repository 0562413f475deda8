// SPDX-License-Identifier: Apache-2.0
// The annotation macros: a function that runs on both sides, and one that is called rather than merged into
// its caller, so that what rarely runs takes no registers from what always does.
#pragma once
#if defined(__CUDACC__)
#define DEM_FN __host__ __device__ __forceinline__
#define DEM_APART __host__ __device__ __noinline__
#else
#define DEM_FN inline
#define DEM_APART [[gnu::noinline]]
#endif

namespace demolish {

/// How a function that is called takes what it reads: on a GPU by value, since parameters of a kernel have no
/// address without a copy, unless they are __grid_constant__; on the host by reference, since there the copy
/// is what costs.
#if defined(__CUDACC__)
template <class T>
using Handed = const T;
#else
template <class T>
using Handed = const T&;
#endif

}  // namespace demolish
