// SPDX-License-Identifier: Apache-2.0
// Choice of the way that a frame travels.
#include "app/bridge/frame_bridge.h"

#include <charconv>
#include <cstdlib>
#include <cstring>

#include "app/bridge/host_bridge.h"
#if DEMOLISH_WITH_CUDA
#include "app/bridge/cuda_copy_bridge.h"
#include "app/bridge/cuda_interop_bridge.h"
#include "engine/render/fracture_mesh.h"
#endif

namespace demolish {

const char* transferName(Transfer transfer) {
    switch (transfer) {
        case Transfer::kInterop:
            return "interop";
        case Transfer::kCopy:
            return "copy";
        case Transfer::kHost:
            return "host";
    }
    return "";
}

namespace {
#if DEMOLISH_WITH_CUDA
constexpr const char* kCopyAskedFor = "DEMOLISH_TRANSFER=copy is set";

/// For drivers whose interop works but misbehaves, and for tests of the copy path.
bool copyAskedFor() {
    const char* wish = std::getenv("DEMOLISH_TRANSFER");
    return wish != nullptr && std::strcmp(wish, "copy") == 0;
}
#endif
}  // namespace

FrameChange ExportHistory::next(const FrameStats& stats, ParticleColour colour, bool fresh) {
    const bool same_lists = !fresh && stats.bonds_broken == broken_;
    // A frame that was skipped may have moved what sleeps now.
    const bool no_frame_between = stats.frame == frame_ || stats.frame == frame_ + 1;
    // A solver that puts nothing to sleep counts neither. What a path leads costs no particle's work, but
    // moves.
    const bool all_asleep =
        stats.awake_particles == 0 && stats.rigid_fragments == 0 && stats.sleeping_fragments > 0;
    const bool effects_rest = !effects_moved_ && !stats.effects_moving;
    const bool at_rest = was_asleep_ && all_asleep && effects_rest && colour == colour_ && no_frame_between;
    effects_moved_ = stats.effects_moving;
    frame_ = stats.frame;
    broken_ = stats.bonds_broken;
    was_asleep_ = all_asleep;
    colour_ = colour;
    if (!same_lists) return FrameChange::kAll;
    return at_rest ? FrameChange::kProjectiles : FrameChange::kMotion;
}

std::unique_ptr<FrameBridge> makeFrameBridge(engine::FractureMesh& mesh, const Solver& solver) {
#if DEMOLISH_WITH_CUDA
    if (solver.onGpu()) {
        std::string why_not = kCopyAskedFor;
        if (copyAskedFor()) return std::make_unique<CudaCopyBridge>(mesh, solver, why_not);
        if (auto bridge = CudaInteropBridge::tryMake(mesh, solver, why_not)) return bridge;
        return std::make_unique<CudaCopyBridge>(mesh, solver, why_not);
    }
#else
    (void)solver;
#endif
    return std::make_unique<HostBridge>(mesh);
}

TransferProbe probeTransfer(bool solver_on_gpu) {
#if DEMOLISH_WITH_CUDA
    if (solver_on_gpu) {
        if (copyAskedFor()) return {Transfer::kCopy, kCopyAskedFor};
        TransferProbe probe;
        probe.transfer = interopWorks(probe.note) ? Transfer::kInterop : Transfer::kCopy;
        return probe;
    }
#endif
    return {Transfer::kHost, solver_on_gpu ? "this program was built without CUDA" : ""};
}

int eglOrdinal(int cuda_ordinal, const char* cuda_visible_devices) {
    if (cuda_visible_devices == nullptr) return cuda_ordinal;
    const char* at = cuda_visible_devices;
    const char* end = at + std::strlen(at);
    for (int position = 0; at < end; ++position) {
        int device = 0;
        const auto [next, error] = std::from_chars(at, end, device);
        if (error != std::errc{}) return cuda_ordinal;  // UUIDs: no mapping without asking the driver
        if (position == cuda_ordinal) return device;
        at = next < end ? next + 1 : next;
    }
    return cuda_ordinal;
}

}  // namespace demolish
