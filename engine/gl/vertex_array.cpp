// SPDX-License-Identifier: Apache-2.0
// One binding point is enough: every layout here is interleaved.
#include "engine/gl/vertex_array.h"

namespace demolish::engine::gl {

VertexArray::VertexArray() {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    object_ = Object<VertexArrayTraits>(id);
}

void VertexArray::floatAttribute(GLuint location, GLint components, GLenum type, bool normalised,
                                 GLuint offset) {
    glEnableVertexArrayAttrib(object_.id(), location);
    glVertexArrayAttribFormat(object_.id(), location, components, type, normalised ? GL_TRUE : GL_FALSE,
                              offset);
    glVertexArrayAttribBinding(object_.id(), location, 0);
}

void VertexArray::integerAttribute(GLuint location, GLint components, GLenum type, GLuint offset) {
    glEnableVertexArrayAttrib(object_.id(), location);
    glVertexArrayAttribIFormat(object_.id(), location, components, type, offset);
    glVertexArrayAttribBinding(object_.id(), location, 0);
}

void VertexArray::advanceByInstance() {
    glVertexArrayBindingDivisor(object_.id(), 0, 1);
}

void VertexArray::setVertices(const Buffer& buffer, GLsizei stride) {
    glVertexArrayVertexBuffer(object_.id(), 0, buffer.id(), 0, stride);
}

void VertexArray::setIndices(const Buffer& buffer) {
    glVertexArrayElementBuffer(object_.id(), buffer.id());
}

void VertexArray::bind() const {
    glBindVertexArray(object_.id());
}

}  // namespace demolish::engine::gl
