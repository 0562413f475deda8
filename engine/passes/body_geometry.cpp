// SPDX-License-Identifier: Apache-2.0
// One vertex layout for the outside and the broken faces: 24 bytes, position, octahedral normal, place, cell.
#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLsizei kVertexBytes = 24;
constexpr GLuint kNormalOffset = 12, kPlaceOffset = 16, kCellOffset = 20;

}  // namespace

bool hasAllBindings() {
    GLint bindings = 0;
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    return bindings >= static_cast<GLint>(StorageBinding::kCount);
}

void bindStorage(StorageBinding binding, const gl::Buffer& buffer) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer.id());
}

void bindNear(const NearFaces& near) {
    bindStorage(StorageBinding::kNearCells, near.cells);
    bindStorage(StorageBinding::kNearIndices, near.indices);
    bindStorage(StorageBinding::kNearVertices, near.vertices);
}

BodyGeometry::BodyGeometry() {
    layout_.floatAttribute(0, 3, GL_FLOAT, false, 0);
    layout_.floatAttribute(1, 2, GL_SHORT, true, kNormalOffset);
    layout_.integerAttribute(2, 1, GL_UNSIGNED_INT, kCellOffset);
    layout_.floatAttribute(3, 2, GL_HALF_FLOAT, false, kPlaceOffset);
    layout_.integerAttribute(4, 1, GL_UNSIGNED_INT, kPlaceOffset);
}

void BodyGeometry::bind(const FractureMesh& mesh, const gl::Buffer& vertices, const gl::Buffer& indices) {
    bindStorage(StorageBinding::kParticleFragment, mesh.stream(StreamId::kParticleFragment));
    bindStorage(StorageBinding::kTransforms, mesh.stream(StreamId::kTransforms));
    bindStorage(StorageBinding::kCellLooks, mesh.cellLooks());
    layout_.setVertices(vertices, kVertexBytes);
    layout_.setIndices(indices);
    layout_.bind();
}

void BodyGeometry::drawCommanded(const FractureMesh& mesh, const gl::Buffer& vertices,
                                 const gl::Buffer& indices, uint32_t command) {
    bind(mesh, vertices, indices);
    mesh.drawCommanded(command);
}

void BodyGeometry::drawListed(const FractureMesh& mesh, const gl::Buffer& vertices,
                              const TriangleList& list) {
    bind(mesh, vertices, list.indices);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(list.count), GL_UNSIGNED_INT, nullptr);
}

void BodyGeometry::drawExterior(const FractureMesh& mesh, const SeenList* seen) {
    if (seen != nullptr) return drawListed(mesh, mesh.exteriorVertices(), seen->exterior);
    drawCommanded(mesh, mesh.exteriorVertices(), mesh.stream(StreamId::kExteriorIndices), kExteriorCommand);
}

void BodyGeometry::drawInterior(const FractureMesh& mesh, const SeenList* seen) {
    const gl::Buffer& vertices = mesh.stream(StreamId::kInteriorVertices);
    if (seen != nullptr) return drawListed(mesh, vertices, seen->interior);
    drawCommanded(mesh, vertices, mesh.stream(StreamId::kInteriorIndices), kInteriorCommand);
}

void BodyGeometry::drawInterior(gl::Program& program, const FractureMesh& mesh, const NearFaces* near,
                                const SeenList* seen) {
    program.set(kLeavesNear, near != nullptr ? 1u : 0u);
    if (near != nullptr) bindNear(*near);
    drawInterior(mesh, seen);
    program.set(kLeavesNear, 0u);
    if (near == nullptr) return;
    if (seen != nullptr) return drawListed(mesh, near->vertices, seen->near);
    bind(mesh, near->vertices, near->indices);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, near->indices.id());
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

}  // namespace demolish::engine
