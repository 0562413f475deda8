// SPDX-License-Identifier: Apache-2.0
// What a window and a headless context have in common.
#pragma once
#include <optional>
#include <string>

namespace demolish::engine {

/// Who draws; for the log, reports and the choice of transfer path.
struct ContextInfo {
    std::string vendor, renderer, version;  ///< as GL says
    std::string platform;                   ///< "GLFW window", "EGL device 0", "EGL surfaceless"
    bool software = false;                  ///< llvmpipe, softpipe or SwiftShader
    int max_samples = 1;                    ///< GL_MAX_SAMPLES
    std::optional<int> cuda_device;  ///< CUDA ordinal that EGL names (not renumbered by CUDA_VISIBLE_DEVICES)
    std::string note;  ///< why the context is not the wished one, with the remedy; empty if it is
};

class GlContext {
  public:
    virtual ~GlContext() = default;
    /// Binds the context to the calling thread.
    virtual void makeCurrent() = 0;
    virtual const ContextInfo& info() const = 0;
};

/// Fills in what GL says about the current context and checks it: throws gl::GlError below OpenGL 4.5.
ContextInfo describeCurrentContext(std::string platform);

}  // namespace demolish::engine
