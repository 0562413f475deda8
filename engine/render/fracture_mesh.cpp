// SPDX-License-Identifier: Apache-2.0
// Allocates the buffers of one body. Streams are resizable storage, the kind that CUDA registers.
#include "engine/render/fracture_mesh.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace demolish::engine {
namespace {

constexpr size_t kChunk = 64;  // vertices
constexpr size_t kVertexBytes = 24, kTransformBytes = 32, kParticleBytes = 32, kGrainBytes = 32,
                 kCrackLineBytes = 8;

/// Of the kind that can be read where it lies.
gl::Buffer fixedBuffer(std::span<const std::byte> data) {
    // A body without, say, crack edges still has a buffer to bind.
    gl::Buffer buffer = gl::Buffer::resizable(std::max<size_t>(data.size(), 16), GL_STATIC_DRAW);
    buffer.upload(data);
    return buffer;
}

size_t streamBytes(StreamId id, const FractureMeshData& data) {
    const size_t particles = std::max(data.particle_capacity, data.particle_count);
    switch (id) {
        case StreamId::kParticles:
            return particles * kParticleBytes;
        case StreamId::kParticleFragment:
            return particles * sizeof(uint32_t);
        case StreamId::kTransforms:
            return particles * kTransformBytes;
        case StreamId::kInteriorVertices:
            return data.interior_vertex_capacity * kVertexBytes;
        case StreamId::kInteriorIndices:
            return data.interior_index_capacity * sizeof(uint32_t);
        case StreamId::kExteriorIndices:
            return data.exterior_indices.size_bytes();
        case StreamId::kCrackEdges:
            return data.crack_capacity * kCrackLineBytes;
        case StreamId::kExteriorVertices:
            return data.exterior_vertices.size();
        case StreamId::kExteriorChunks:
            return (data.exterior_vertices.size() / kVertexBytes + kChunk - 1) / kChunk * sizeof(uint32_t);
        case StreamId::kCommands:
            return 3 * kDrawCommandBytes;
        case StreamId::kGrains:
            return data.grain_capacity * kGrainBytes;
        case StreamId::kPuffs:
            return data.puff_capacity * kPuffBytes;
        case StreamId::kEffectCommands:
            return kEffectCommandCount * kEffectCommandBytes;
        case StreamId::kCount:
            break;
    }
    return 0;
}

/// Is it read before a frame is written? Of the others commands say how much there is, which is nothing.
bool isReadUnwritten(StreamId id) {
    return id == StreamId::kParticles || id == StreamId::kParticleFragment || id == StreamId::kTransforms ||
           id == StreamId::kCommands || id == StreamId::kEffectCommands || id == StreamId::kExteriorChunks;
}

}  // namespace

uint32_t cellLook(uint32_t look, float paleness) {
    const auto steps = static_cast<int16_t>(std::lround(32767 * std::clamp(paleness, -1.0f, 1.0f)));
    return look | static_cast<uint32_t>(static_cast<uint16_t>(steps)) << 16;
}

uint64_t FractureMesh::nextVersion() {
    static std::atomic<uint64_t> last{0};
    return ++last;
}

FractureMesh::FractureMesh(const FractureMeshData& data)
    : crack_edges_(fixedBuffer(data.crack_edges)),
      cell_looks_(fixedBuffer(std::as_bytes(data.cell_looks))),
      particle_count_(data.particle_count),
      particle_capacity_(std::max(data.particle_capacity, data.particle_count)) {
    for (size_t i = 0; i < streams_.size(); ++i) {
        const auto id = static_cast<StreamId>(i);
        const size_t bytes = std::max<size_t>(streamBytes(id, data), 64);
        streams_[i] = isReadUnwritten(id) ? gl::Buffer::zeros(bytes) : gl::Buffer::resizable(bytes);
    }
    if (!data.cell_spheres.empty()) cell_spheres_ = fixedBuffer(std::as_bytes(data.cell_spheres));
    if (data.looks != nullptr) looks_.emplace(*data.looks);
    // Until the first frame is written the body stands whole where it was made: all cells in slot 0, which
    // does not move.
    const float identity[8] = {0, 0, 0, 1, 0, 0, 0, 0};
    stream(StreamId::kTransforms).upload(std::as_bytes(std::span(identity)));
    stream(StreamId::kExteriorVertices).upload(data.exterior_vertices);
    stream(StreamId::kExteriorIndices).upload(std::as_bytes(data.exterior_indices));
    const uint32_t exterior[5] = {static_cast<uint32_t>(data.exterior_indices.size()), 1, 0, 0, 0};
    stream(StreamId::kCommands)
        .upload(std::as_bytes(std::span(exterior)), kExteriorCommand * kDrawCommandBytes);
}

void FractureMesh::drawCommanded(uint32_t command) const {
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, stream(StreamId::kCommands).id());
    // OpenGL takes an offset in the buffer where it once took an address.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* offset = reinterpret_cast<const void*>(command * kDrawCommandBytes);
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, offset);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void FractureMesh::drawEffect(uint32_t command, GLenum mode) const {
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, stream(StreamId::kEffectCommands).id());
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    glDrawArraysIndirect(mode, reinterpret_cast<const void*>(command * kEffectCommandBytes));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

}  // namespace demolish::engine
