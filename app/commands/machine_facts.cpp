// SPDX-License-Identifier: Apache-2.0
// Read from /proc and asked of the CUDA runtime.
#include "app/commands/machine_facts.h"

#include <tbb/global_control.h>

#include <fstream>

#include "sim_cuda/api/solver.h"

namespace demolish {

unsigned threadsInUse() {
    return static_cast<unsigned>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

std::string machineName() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);) {
        const auto colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

std::string gpuDriver() {
    std::string version;
    std::ifstream("/sys/module/nvidia/version") >> version;
    std::string text = version.empty() ? "" : "NVIDIA " + version;
    const CudaDevice cuda = findCudaDevice();
    if (cuda.driver_version > 0)
        text += (text.empty() ? "CUDA " : ", CUDA ") + std::to_string(cuda.driver_version / 1000) + "." +
                std::to_string(cuda.driver_version % 1000 / 10);
    return text.empty() ? "none" : text;
}

}  // namespace demolish
