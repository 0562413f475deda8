// SPDX-License-Identifier: Apache-2.0
// Chooses the EGL device that computes, else another GPU, else Mesa's software: the renderer is the same on
// all of them.
#include "engine/platform/headless_context.h"

#include <algorithm>
#include <utility>

#include <glad/gl.h>

#include "engine/gl/error.h"
#include "engine/platform/egl_display.h"

namespace demolish::engine {

struct HeadlessContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    ContextInfo info;

    ~State() {
        if (context == EGL_NO_CONTEXT) return;
        if (eglGetCurrentContext() == context) {
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(display, context);
    }
};

namespace {

struct Candidate {
    EGLDisplay display;
    std::string platform;
    std::optional<int> cuda_device;
};

int rank(const EglDevice& device, const HeadlessOptions& options) {
    if (device.software) return 3;
    if (options.cuda_device && device.cuda_device == options.cuda_device) return 0;
    return device.cuda_device ? 1 : 2;
}

std::vector<Candidate> candidates(const HeadlessOptions& options) {
    const std::vector<EGLDeviceEXT> handles = queryEglDevices();
    std::vector<EglDevice> devices = listEglDevices();
    std::stable_sort(devices.begin(), devices.end(), [&](const EglDevice& a, const EglDevice& b) {
        return rank(a, options) < rank(b, options);
    });
    std::vector<Candidate> result;
    for (const EglDevice& device : devices) {
        if (!device.usable || (options.software_only && !device.software)) continue;
        result.push_back({openDeviceDisplay(handles[device.index]),
                          "EGL device " + std::to_string(device.index), device.cuda_device});
    }
    if (const EGLDisplay display = openSurfacelessDisplay(); display != EGL_NO_DISPLAY) {
        result.push_back({display, "EGL surfaceless", std::nullopt});
    }
    return result;
}

EGLContext createContext(EGLDisplay display, bool debug) {
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return EGL_NO_CONTEXT;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_CONTEXT_OPENGL_DEBUG,
                                 debug ? EGL_TRUE : EGL_FALSE,
                                 EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

std::string noteFor(const HeadlessOptions& options, const ContextInfo& info) {
    if (!options.cuda_device || info.cuda_device == options.cuda_device) return "";
    return "No EGL device belongs to CUDA device " + std::to_string(*options.cuda_device) +
           ", so frames are copied; if this machine has an NVIDIA GPU, install its EGL driver or set "
           "__EGL_VENDOR_LIBRARY_FILENAMES=/usr/share/glvnd/egl_vendor.d/10_nvidia.json.";
}

}  // namespace

std::vector<EglDevice> listEglDevices() {
    loadEgl();
    std::vector<EglDevice> result;
    for (const EGLDeviceEXT device : queryEglDevices()) {
        result.push_back(describeEglDevice(device, static_cast<int>(result.size())));
    }
    return result;
}

HeadlessContext::HeadlessContext(const HeadlessOptions& options) : state_(std::make_unique<State>()) {
    loadEgl();
    std::string failures;
    for (const Candidate& candidate : candidates(options)) {
        state_->display = candidate.display;
        state_->context = createContext(candidate.display, options.debug);
        if (state_->context == EGL_NO_CONTEXT) {
            failures += " " + candidate.platform + ": " + eglErrorName() + ".";
            continue;
        }
        makeCurrent();
        if (gladLoadGL(reinterpret_cast<GLADloadfunc>(eglGetProcAddress)) == 0) {
            throw gl::GlError("The OpenGL functions of " + candidate.platform +
                              " cannot be loaded; reinstall libgl1.");
        }
        state_->info = describeCurrentContext(candidate.platform);
        if (options.software_only &&
            !state_->info.software) {  // a GPU driver may answer the surfaceless platform too
            failures += " " + candidate.platform + ": " + state_->info.renderer + " is not software.";
            eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(state_->display, std::exchange(state_->context, EGL_NO_CONTEXT));
            continue;
        }
        state_->info.cuda_device = candidate.cuda_device;
        state_->info.note = noteFor(options, state_->info);
        gl::installDebugCallback();
        return;
    }
    throw gl::GlError(
        "No EGL device gives OpenGL 4.5 core without a display; install the GPU's driver or Mesa's "
        "libegl-mesa0 and libgl1-mesa-dri." +
        failures);
}

HeadlessContext::~HeadlessContext() = default;

void HeadlessContext::makeCurrent() {
    if (eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context) != EGL_TRUE) {
        throw gl::GlError("The headless OpenGL context cannot be made current: " + eglErrorName() +
                          "; is it current on another thread?");
    }
}

const ContextInfo& HeadlessContext::info() const {
    return state_->info;
}

}  // namespace demolish::engine
