// SPDX-License-Identifier: Apache-2.0
// Owning vertex array: the layout of vertices, apart from the buffers that hold them.
#pragma once
#include <cstdint>

#include "engine/gl/buffer.h"
#include "engine/gl/object.h"

namespace demolish::engine::gl {

struct VertexArrayTraits {
    static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};

class VertexArray {
  public:
    VertexArray();

    /// Attribute read as floats; `type` as glVertexArrayAttribFormat. All attributes share binding 0.
    void floatAttribute(GLuint location, GLint components, GLenum type, bool normalised, GLuint offset);
    /// Attribute read as integers.
    void integerAttribute(GLuint location, GLint components, GLenum type, GLuint offset);
    /// What is read goes on with each instance, not with each vertex.
    void advanceByInstance();
    void setVertices(const Buffer& buffer, GLsizei stride);
    void setIndices(const Buffer& buffer);
    void bind() const;

  private:
    Object<VertexArrayTraits> object_;
};

}  // namespace demolish::engine::gl
