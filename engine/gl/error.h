// SPDX-License-Identifier: Apache-2.0
// The one exception of OpenGL set-up and the hook that turns driver messages into it.
#pragma once
#include <stdexcept>
#include <string>

namespace demolish::engine::gl {

/// Context, shader, framebuffer or driver error; what() is one sentence with the remedy where there is one.
class GlError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Collects the driver's error messages (KHR_debug) of the current context from now on.
void installDebugCallback();

/// Throws GlError with the driver's first message since the last call, if there was one. `where` names the
/// caller. Without a debug context drivers may report less; glGetError is asked as well.
void throwIfError(const char* where);

/// Forgets what was reported so far, for a caller that is about to throw a better message of its own.
void discardErrors();

}  // namespace demolish::engine::gl
