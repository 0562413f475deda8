// SPDX-License-Identifier: Apache-2.0
// What the GPU's floor says in a build without the toolkit.
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/substep_bench.h"
#include "sim_cuda/bench/floor_schemes.h"

namespace demolish {
namespace {

constexpr const char* kSentence =
    "This program was built without CUDA; install the CUDA toolkit and build again, or use --device cpu.";

}  // namespace

SubstepFloor cudaSubstepFloor(const BreakableBody&) {
    throw DeviceError(kSentence);
}

std::vector<FloorOutcome> cudaFloorOutcomes(const FloorProblem&, uint32_t) {
    throw DeviceError(kSentence);
}

}  // namespace demolish
