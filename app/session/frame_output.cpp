// SPDX-License-Identifier: Apache-2.0
// Buffers of all bodies, sized by what the solver may write.
#include "app/session/frame_output.h"

#include <algorithm>
#include <cmath>
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

/// Of each particle's cell: centre at rest, and how far its corners reach.
std::vector<glm::vec4> spheresOfCells(const BuiltShot& built) {
    std::vector<glm::vec4> spheres;
    for (const auto& body : built.cells.of_body) {
        const CellCorners& corners = body->corners;
        for (size_t i = 0; i < body->particles.size(); ++i) {
            const Particle& particle = body->particles[i];
            double reach = std::cbrt(particle.volume);  // a cell's corners lie within 0.9 of it
            const uint32_t end = corners.start.empty() ? 0 : corners.start[i + 1];
            for (uint32_t c = corners.start.empty() ? 0 : corners.start[i]; c < end; ++c) {
                const Double3& corner = corners.from_seed[c];
                reach = std::max(reach, std::hypot(corner.x, corner.y, corner.z));
            }
            spheres.emplace_back(particle.seed.x, particle.seed.y, particle.seed.z, reach);
        }
    }
    return spheres;
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
    const std::vector<glm::vec4> cell_spheres = spheresOfCells(built);
    data.cell_spheres = cell_spheres;
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
