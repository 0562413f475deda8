// Launches of kernels that may start while the one before still runs (programmatic dependent launch): such a
// kernel calls letNextStart() and, before it reads what others write, awaitPrevious().
#pragma once
#include <utility>

#include "sim_cuda/backend/cuda_backend.cuh"

namespace demolish {

/// Whether the code that runs was compiled for a GPU on which kernels can wait for the one before.
template <class Kernel>
bool awaitsPrevious(Kernel* kernel) {
    cudaFuncAttributes attributes{};
    return cudaFuncGetAttributes(&attributes, kernel) == cudaSuccess && attributes.ptxVersion >= 90;
}

/// `follows`: the launch before it on this stream is of such a kernel too, and nothing that this one reads
/// before awaitPrevious() is written by any of those that may still run. Throws on failure.
template <class... Parameters, class... Arguments>
void launchChained(cudaStream_t stream, bool follows, void (*kernel)(Parameters...), uint32_t blocks,
                   uint32_t threads, Arguments&&... arguments) {
    cudaLaunchAttribute early{};
    early.id = cudaLaunchAttributeProgrammaticStreamSerialization;
    early.val.programmaticStreamSerializationAllowed = 1;
    cudaLaunchConfig_t config{};
    config.gridDim = blocks;
    config.blockDim = threads;
    config.stream = stream;
    config.attrs = &early;
    config.numAttrs = follows && awaitsPrevious(kernel) ? 1 : 0;
    checkCuda(cudaLaunchKernelEx(&config, kernel, std::forward<Arguments>(arguments)...), "starting a step");
}

}  // namespace demolish
