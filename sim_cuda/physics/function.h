// SPDX-License-Identifier: Apache-2.0
// The one annotation macro: a function that runs on both sides.
#pragma once
#if defined(__CUDACC__)
#define DEM_FN __host__ __device__ __forceinline__
#else
#define DEM_FN inline
#endif
