// SPDX-License-Identifier: Apache-2.0
// The solver on the GPU, and the question whether there is one.
#include "sim_cuda/solver/cuda_pair_finder.cuh"
#include "sim_cuda/solver/cuda_rigid_runner.cuh"
#include "sim_cuda/solver/cuda_substep_runner.cuh"
#include "sim_cuda/solver/device_solver.h"

namespace demolish {

std::unique_ptr<Solver> makeCudaSolver(const SceneSetup& setup, const ProgressCallback& progress) {
    const CudaDevice device = findCudaDevice();
    if (!device.usable) throw DeviceError("No usable GPU: " + device.problem + "; use --device cpu.");
    return std::make_unique<DeviceSolver<CudaBackend, float>>(setup, progress);
}

CudaDevice findCudaDevice() {
    CudaDevice device;
    device.built_with_cuda = true;
    cudaError_t problem = cudaDriverGetVersion(&device.driver_version);
    if (problem == cudaSuccess && device.driver_version == 0) {
        device.problem = "this machine has no NVIDIA driver";
        return device;
    }
    if (problem == cudaSuccess) problem = cudaGetDeviceCount(&device.count);
    if (problem == cudaSuccess) problem = cudaGetDevice(&device.ordinal);
    cudaDeviceProp properties{};
    if (problem == cudaSuccess) problem = cudaGetDeviceProperties(&properties, device.ordinal);
    cudaFuncAttributes attributes{};
    if (problem == cudaSuccess)
        problem = cudaFuncGetAttributes(&attributes, substepKernel<4, false, false, true, float>);
    cudaGetLastError();  // a missing GPU is no error of what follows
    if (problem != cudaSuccess) {
        device.problem = cudaGetErrorString(problem);
        return device;
    }
    device.name = properties.name;
    device.usable = true;
    return device;
}

}  // namespace demolish
