// SPDX-License-Identifier: Apache-2.0
// Counts from the indirect draw commands.
#include "app/session/triangle_counter.h"

#include "engine/render/fracture_mesh.h"
#include "sim_cuda/api/render_streams.h"

namespace demolish {

uint64_t TriangleCounter::count(const engine::FractureMesh* mesh, uint32_t bonds_broken) {
    if (mesh == nullptr) return 0;
    if (mesh == mesh_ && mesh->particleCount() == particles_ && bonds_broken == bonds_broken_) return count_;
    DrawCommands commands{};
    mesh->stream(engine::StreamId::kCommands)
        .download(std::as_writable_bytes(std::span<DrawCommands>(&commands, 1)));
    const uint64_t corners = uint64_t{commands.exterior.count} + commands.interior.count +
                             uint64_t{commands.cracks.count} * commands.cracks.instance_count;
    mesh_ = mesh;
    particles_ = mesh->particleCount();
    bonds_broken_ = bonds_broken;
    count_ = corners / 3;
    return count_;
}

}  // namespace demolish
