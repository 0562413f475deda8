// SPDX-License-Identifier: Apache-2.0
// OpenGL without a display: a surfaceless EGL context, on the GPU that computes where there is one.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/platform/gl_context.h"

namespace demolish::engine {

struct HeadlessOptions {
    std::optional<int> cuda_device;  ///< wanted CUDA ordinal (as EGL counts); none: the first GPU
    bool software_only = false;      ///< take Mesa's software device even if there is a GPU
    bool debug = false;              ///< debug context: the driver reports more and runs slower
};

/// One EGL device as the driver lists it.
struct EglDevice {
    int index = 0;
    bool software = false;
    bool usable = false;             ///< eglInitialize works
    std::optional<int> cuda_device;  ///< EGL_CUDA_DEVICE_NV
    std::string vendor;              ///< EGL_VENDOR of its display
};
std::vector<EglDevice> listEglDevices();

class HeadlessContext : public GlContext {
  public:
    /// Order of choice: the device of `cuda_device`, other GPUs, software devices, Mesa's surfaceless
    /// platform. Current on return. Throws gl::GlError with the remedy when none gives OpenGL 4.5.
    explicit HeadlessContext(const HeadlessOptions& options = {});
    ~HeadlessContext() override;

    void makeCurrent() override;
    const ContextInfo& info() const override;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace demolish::engine
