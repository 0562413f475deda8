// SPDX-License-Identifier: Apache-2.0
// Buffers of all bodies, sized by what the solver may write.
#include "app/session/frame_output.h"

#include <random>

#include "app/session/scene_looks.h"
#include "app/session/shot_bodies.h"
#include "engine/render/fracture_mesh.h"

namespace demolish {

namespace {

/// Of each particle; empty where there is nothing to tell apart.
std::vector<uint32_t> looksOfCells(const BuiltShot& built) {
    const ShotLooks list = looksOf(built.shot);
    std::vector<uint32_t> looks;
    if (!list.areSeveral() && list.of_body.size() == 1) return looks;
    std::mt19937 random;  // the same for each run
    for (size_t b = 0; b < list.of_body.size(); ++b) {
        const float paleness = 2 * static_cast<float>(random() / 4294967296.0) - 1;
        looks.insert(looks.end(), built.cells.of_body[b]->particles.size(),
                     engine::cellLook(list.of_body[b], paleness));
    }
    return looks;
}

}  // namespace

FrameOutput::FrameOutput(const BuiltShot& built) {
    const FractureGeometry geometry = sceneExterior(built.setup);
    const StreamSizes sizes = streamSizes(built.setup);
    engine::FractureMeshData data;
    data.exterior_vertices = std::as_bytes(std::span(geometry.exterior));
    data.exterior_indices = geometry.exterior_indices;
    data.crack_edges = std::as_bytes(std::span(geometry.crack_edges));
    const std::vector<uint32_t> cell_looks = looksOfCells(built);
    data.cell_looks = cell_looks;
    data.particle_count = built.solver->stats().particles;
    data.particle_capacity = sizes.particles;
    data.interior_vertex_capacity = sizes.interior_vertices;
    data.interior_index_capacity = sizes.interior_indices;
    data.crack_capacity = sizes.crack_edges;
    data.grain_capacity = sizes.grains;
    data.puff_capacity = sizes.puffs;
    const auto looks = sceneLooks(built.setup);
    if (looks) data.looks = &*looks;
    mesh_ = std::make_unique<engine::FractureMesh>(data);
    bridge_ = makeFrameBridge(*mesh_, *built.solver);
}

FrameOutput::~FrameOutput() = default;

std::vector<engine::SphereDraw> spheresOf(std::span<const ParticleInstance> projectiles) {
    std::vector<engine::SphereDraw> spheres;
    for (const auto& ball : projectiles)
        spheres.push_back({{ball.position.x, ball.position.y, ball.position.z}, ball.radius});
    return spheres;
}

}  // namespace demolish
