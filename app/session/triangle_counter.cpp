// Counts from the indirect draw commands.
#include "app/session/triangle_counter.h"

#include "sim_cuda/api/render_streams.h"

namespace demolish {

uint64_t TriangleCounter::count(const engine::FractureMesh* mesh, uint32_t bonds_broken) {
    if (mesh == nullptr) return 0;
    const bool known =
        mesh == mesh_ && mesh->exteriorIndexCount() == exterior_indices_ && bonds_broken == bonds_broken_;
    if (known) return count_;
    DrawCommands commands{};
    mesh->stream(engine::StreamId::kCommands)
        .download(std::as_writable_bytes(std::span<DrawCommands>(&commands, 1)));
    const uint64_t corners = uint64_t{mesh->exteriorIndexCount()} + commands.interior.count +
                             uint64_t{commands.cracks.count} * commands.cracks.instance_count;
    mesh_ = mesh;
    exterior_indices_ = mesh->exteriorIndexCount();
    bonds_broken_ = bonds_broken;
    count_ = corners / 3;
    return count_;
}

}  // namespace demolish
