// Launches of kernels that may start while the one before still runs (programmatic dependent launch): such a
// kernel calls letNextStart() and, before it reads or writes what others write, awaitPrevious().
#pragma once
#include <cuda_runtime.h>

#include <cstdint>
#include <utility>

#include "sim_cuda/backend/cuda_error.h"

namespace demolish {

/// The kernel after this one may start. Nothing on GPUs that know of no such thing.
__device__ __forceinline__ void letNextStart() {
#if __CUDA_ARCH__ >= 900
    cudaTriggerProgrammaticLaunchCompletion();
#endif
}
/// Until all that was started before is done and can be seen.
__device__ __forceinline__ void awaitPrevious() {
#if __CUDA_ARCH__ >= 900
    cudaGridDependencySynchronize();
#endif
}

/// Whether the code that runs was compiled for a GPU on which kernels can wait for the one before.
template <class Kernel>
bool awaitsPrevious(Kernel* kernel) {
    cudaFuncAttributes attributes{};
    return cudaFuncGetAttributes(&attributes, kernel) == cudaSuccess && attributes.ptxVersion >= 90;
}

/// `follows`: whatever is launched before it on this stream, nothing that this one reads before
/// awaitPrevious() is written by anything that may still run. `name`: what for, in messages. Throws on
/// failure.
template <class... Parameters, class... Arguments>
void launchChained(cudaStream_t stream, bool follows, void (*kernel)(Parameters...), dim3 blocks,
                   uint32_t threads, const char* name, Arguments&&... arguments) {
    static const bool awaits = awaitsPrevious(kernel);  // the kernels of a build are compiled alike
    cudaLaunchAttribute early{};
    early.id = cudaLaunchAttributeProgrammaticStreamSerialization;
    early.val.programmaticStreamSerializationAllowed = 1;
    cudaLaunchConfig_t config{};
    config.gridDim = blocks;
    config.blockDim = threads;
    config.stream = stream;
    config.attrs = &early;
    config.numAttrs = follows && awaits ? 1 : 0;
    checkCuda(cudaLaunchKernelEx(&config, kernel, std::forward<Arguments>(arguments)...), name);
}

}  // namespace demolish
