// SPDX-License-Identifier: Apache-2.0
// Straight into the host's memory, or through the device's.
#include "app/bridge/fragment_reader.h"

#if DEMOLISH_WITH_CUDA
#include "app/bridge/cuda_fragment_reader.h"
#endif

namespace demolish {

std::vector<uint32_t> readFragments(Solver& solver) {
#if DEMOLISH_WITH_CUDA
    if (solver.onGpu()) return readFragmentsFromGpu(solver);
#endif
    std::vector<uint32_t> fragments(solver.stats().particles);
    RenderStreams streams;
    streams.particle_fragment = {fragments.data(), fragments.size()};
    solver.exportFrame(streams);
    solver.synchronize();
    return fragments;
}

}  // namespace demolish
