// SPDX-License-Identifier: Apache-2.0
// What a driver offers beyond OpenGL 4.5.
#pragma once
#include <glad/gl.h>

#include <string_view>

namespace demolish::engine::gl {

/// Does the current context's driver have it? `name`: such as "GL_NV_shader_atomic_int64".
inline bool hasExtension(std::string_view name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint k = 0; k < count; ++k)
        if (name == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(k))))
            return true;
    return false;
}

}  // namespace demolish::engine::gl
