// SPDX-License-Identifier: Apache-2.0
// Driver messages become exceptions at a place of our choosing: a C callback must not throw.
#include "engine/gl/error.h"

#include <glad/gl.h>

#include <utility>

namespace demolish::engine::gl {
namespace {

thread_local std::string first_message;

void GLAD_API_PTR onMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                            const void*) {
    const bool error = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR;
    if (!error || severity == GL_DEBUG_SEVERITY_NOTIFICATION || !first_message.empty()) return;
    first_message.assign(text, length < 0 ? std::string(text).size() : static_cast<size_t>(length));
}

}  // namespace

void installDebugCallback() {
    if (glDebugMessageCallback == nullptr) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);  // the message then belongs to the call that the thread is in
    glDebugMessageCallback(onMessage, nullptr);
}

void throwIfError(const char* where) {
    const GLenum code = glGetError();
    if (code == GL_NO_ERROR && first_message.empty()) return;
    std::string message = std::exchange(first_message, {});
    discardErrors();
    if (message.empty()) message = "GL error code " + std::to_string(code);
    throw GlError(std::string(where) + ": " + message);
}

void discardErrors() {
    while (glGetError() != GL_NO_ERROR) {
    }
    first_message.clear();
}

}  // namespace demolish::engine::gl
