// SPDX-License-Identifier: Apache-2.0
// One vertex layout for the outside and the broken faces: 24 bytes, position, octahedral normal, place, cell.
#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLsizei kVertexBytes = 24;
constexpr GLuint kNormalOffset = 12, kPlaceOffset = 16, kCellOffset = 20;

}  // namespace

void bindStorage(StorageBinding binding, const gl::Buffer& buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer.id());
}

BodyGeometry::BodyGeometry() {
    layout_.floatAttribute(0, 3, GL_FLOAT, false, 0);
    layout_.floatAttribute(1, 2, GL_SHORT, true, kNormalOffset);
    layout_.integerAttribute(2, 1, GL_UNSIGNED_INT, kCellOffset);
    layout_.floatAttribute(3, 2, GL_HALF_FLOAT, false, kPlaceOffset);
    layout_.integerAttribute(4, 1, GL_UNSIGNED_INT, kPlaceOffset);
}

void BodyGeometry::draw(const FractureMesh& mesh, const gl::Buffer& vertices, const gl::Buffer& indices,
                        uint32_t command) {
    bindStorage(StorageBinding::kParticleFragment, mesh.stream(StreamId::kParticleFragment));
    bindStorage(StorageBinding::kTransforms, mesh.stream(StreamId::kTransforms));
    bindStorage(StorageBinding::kCellLooks, mesh.cellLooks());
    layout_.setVertices(vertices, kVertexBytes);
    layout_.setIndices(indices);
    layout_.bind();
    mesh.drawCommanded(command);
}

void BodyGeometry::drawExterior(const FractureMesh& mesh) {
    draw(mesh, mesh.exteriorVertices(), mesh.stream(StreamId::kExteriorIndices), kExteriorCommand);
}

void BodyGeometry::drawInterior(const FractureMesh& mesh) {
    draw(mesh, mesh.stream(StreamId::kInteriorVertices), mesh.stream(StreamId::kInteriorIndices),
         kInteriorCommand);
}

}  // namespace demolish::engine
