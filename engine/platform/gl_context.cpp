// SPDX-License-Identifier: Apache-2.0
// Reads what the current context is and refuses one that the renderer cannot use.
#include "engine/platform/gl_context.h"

#include <glad/gl.h>

#include <algorithm>
#include <cctype>

#include "engine/gl/error.h"

namespace demolish::engine {
namespace {

std::string text(GLenum name) {
    const auto* value = reinterpret_cast<const char*>(glGetString(name));
    return value != nullptr ? value : "";
}

bool isSoftware(std::string renderer) {
    std::transform(renderer.begin(), renderer.end(), renderer.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos ||
           renderer.find("swiftshader") != std::string::npos;
}

}  // namespace

ContextInfo describeCurrentContext(std::string platform) {
    ContextInfo info;
    info.vendor = text(GL_VENDOR);
    info.renderer = text(GL_RENDERER);
    info.version = text(GL_VERSION);
    info.platform = std::move(platform);
    info.software = isSoftware(info.renderer);
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_MAX_SAMPLES, &info.max_samples);
    if (major * 10 + minor < 45) {
        throw gl::GlError("OpenGL 4.5 is needed, '" + info.renderer + "' offers " + info.version +
                          "; update the graphics driver or install Mesa's libgl1-mesa-dri.");
    }
    return info;
}

}  // namespace demolish::engine
