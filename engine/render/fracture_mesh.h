// SPDX-License-Identifier: Apache-2.0
// GPU buffers of one shot: static geometry and the streams that a simulation writes. The engine knows nothing
// of the simulation: whoever fills the streams gets integer buffer ids and an update rule.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "engine/gl/buffer.h"
#include "engine/looks/look_buffers.h"
#include "engine/render/stream_id.h"

namespace demolish::engine {

/// Bytes as they lie in the buffers (std430 / vertex attributes); sizes are checked by whoever fills them.
struct FractureMeshData {
    std::span<const std::byte> exterior_vertices;  ///< what their stream starts with
    std::span<const uint32_t>
        exterior_indices;  ///< 3 per triangle; what is drawn until the stream says otherwise
    std::span<const std::byte> crack_edges;  ///< 20 B each: vertex_0, vertex_1, cell_a, cell_b, bond
    /// One a cell, as cellLook() makes them; or none: all have look 0 and no SurfaceLook::variation.
    std::span<const uint32_t> cell_looks;
    /// One a cell: centre at rest and how far it reaches, m; or none: broken faces get no relief.
    std::span<const glm::vec4> cell_spheres;
    size_t particle_count = 0;     ///< cells, without projectiles
    size_t particle_capacity = 0;  ///< instances incl. projectiles
    size_t interior_vertex_capacity = 0;
    size_t interior_index_capacity = 0;
    size_t crack_capacity = 0;
    size_t grain_capacity = 0, puff_capacity = 0;
    const BodyLooks* looks = nullptr;  ///< null: no model has its own
};

/// `paleness`: -1..1, of the cell's body among those of its look.
uint32_t cellLook(uint32_t look, float paleness);

class FractureMesh {
  public:
    explicit FractureMesh(const FractureMeshData& data);

    /// For writing: counts as a change.
    gl::Buffer& stream(StreamId id) {
        touch();
        return streams_[static_cast<size_t>(id)];
    }
    const gl::Buffer& stream(StreamId id) const { return streams_[static_cast<size_t>(id)]; }
    const gl::Buffer& exteriorVertices() const { return stream(StreamId::kExteriorVertices); }
    /// Of the models themselves; null: none.
    const LookBuffers* looks() const { return looks_ ? &*looks_ : nullptr; }
    const gl::Buffer& crackEdges() const { return crack_edges_; }
    /// Of each cell, for shaders/common/cell_look.glsl.
    const gl::Buffer& cellLooks() const { return cell_looks_; }
    /// Of each cell, as FractureMeshData has them; empty where nobody said.
    const gl::Buffer& cellSpheres() const { return cell_spheres_; }
    /// Triangles as one of the stream's commands says, of what is bound.
    void drawCommanded(uint32_t command) const;
    /// What one of the effects' commands says, of what is bound; `mode` as glDrawArrays.
    void drawEffect(uint32_t command, GLenum mode) const;
    /// Whether the effects' streams hold anything to draw, and whether any of it still flies: what lies is
    /// grit alone. Until it is said there is nothing.
    void showEffects(bool shown, bool flying) {
        effects_shown_ = shown;
        effects_fly_ = shown && flying;
    }
    bool effectsShown() const { return effects_shown_; }
    bool effectsFly() const { return effects_fly_; }
    /// The streams were written from outside, by whoever knows the buffers' ids.
    void touch() { version_ = nextVersion(); }
    /// Changes with the streams' contents; no two meshes have the same.
    uint64_t version() const { return version_; }
    size_t particleCount() const { return particle_count_; }
    size_t particleCapacity() const { return particle_capacity_; }

  private:
    static uint64_t nextVersion();
    gl::Buffer crack_edges_, cell_looks_, cell_spheres_;
    std::optional<LookBuffers> looks_;
    std::array<gl::Buffer, static_cast<size_t>(StreamId::kCount)> streams_;
    size_t particle_count_ = 0, particle_capacity_ = 0;
    bool effects_shown_ = false, effects_fly_ = false;
    uint64_t version_ = nextVersion();
};

}  // namespace demolish::engine
