// SPDX-License-Identifier: Apache-2.0
// eglGetDisplay(default) fails without a display server, so only devices and Mesa's surfaceless platform are
// used.
#include "engine/platform/egl_display.h"

#include <dlfcn.h>

#include <cstring>

#include "engine/gl/error.h"

namespace demolish::engine {
namespace {

bool hasWord(const char* list, const char* word) {
    return list != nullptr && std::strstr(list, word) != nullptr;
}

EGLDisplay initialised(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY) return display;
    return eglInitialize(display, nullptr, nullptr) == EGL_TRUE ? display : EGL_NO_DISPLAY;
}

GLADapiproc findFunction(const char* name) {
    static void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        throw gl::GlError("libEGL.so.1 is missing; install libegl1 (Debian, Ubuntu) or run with a window.");
    if (void* symbol = dlsym(library, name)) return reinterpret_cast<GLADapiproc>(symbol);
    return eglGetProcAddress != nullptr ? reinterpret_cast<GLADapiproc>(eglGetProcAddress(name)) : nullptr;
}

template <class Function>
void find(Function& function, const char* name) {
    function = reinterpret_cast<Function>(findFunction(name));
}

/// What it takes to open a display; linking libEGL instead would keep the program from starting where it is
/// missing.
void findFirstFunctions() {
    find(eglGetProcAddress, "eglGetProcAddress");
    find(eglGetPlatformDisplay, "eglGetPlatformDisplay");
    find(eglInitialize, "eglInitialize");
    find(eglQueryString, "eglQueryString");
    // Client extensions: the generated loader looks for them among a display's and does not find them.
    find(eglQueryDevicesEXT, "eglQueryDevicesEXT");
    find(eglQueryDeviceStringEXT, "eglQueryDeviceStringEXT");
    find(eglQueryDeviceAttribEXT, "eglQueryDeviceAttribEXT");
    if (eglGetPlatformDisplay == nullptr || eglInitialize == nullptr || eglQueryString == nullptr) {
        throw gl::GlError(
            "libEGL.so.1 is older than EGL 1.5; update the graphics driver or run with a window.");
    }
}

bool loadRest(EGLDisplay display) {
    return display != EGL_NO_DISPLAY && gladLoadEGL(display, findFunction) != 0;
}

}  // namespace

void loadEgl() {
    static const bool loaded = [] {
        findFirstFunctions();
        // The generated loader asks an initialised display for the version before it fetches the rest.
        for (const EGLDeviceEXT device : queryEglDevices()) {
            if (loadRest(openDeviceDisplay(device))) return true;
        }
        return loadRest(openSurfacelessDisplay());
    }();
    if (!loaded) {
        throw gl::GlError(
            "No EGL device starts without a display; install the GPU's driver or Mesa's libegl-mesa0 and "
            "libgl1-mesa-dri.");
    }
}

std::vector<EGLDeviceEXT> queryEglDevices() {
    EGLint count = 0;
    if (eglQueryDevicesEXT == nullptr || eglQueryDeviceStringEXT == nullptr ||
        eglQueryDeviceAttribEXT == nullptr)
        return {};
    if (eglQueryDevicesEXT(0, nullptr, &count) != EGL_TRUE) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<size_t>(count));
    if (count > 0) eglQueryDevicesEXT(count, devices.data(), &count);
    return devices;
}

EGLDisplay openDeviceDisplay(EGLDeviceEXT device) {
    return initialised(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
}

EGLDisplay openSurfacelessDisplay() {
    if (!hasWord(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless"))
        return EGL_NO_DISPLAY;
    return initialised(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
}

EglDevice describeEglDevice(EGLDeviceEXT device, int index) {
    EglDevice facts;
    facts.index = index;
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    facts.software = hasWord(extensions, "EGL_MESA_device_software");
    EGLAttrib ordinal = 0;
    if (hasWord(extensions, "EGL_NV_device_cuda") &&
        eglQueryDeviceAttribEXT(device, EGL_CUDA_DEVICE_NV, &ordinal) == EGL_TRUE) {
        facts.cuda_device = static_cast<int>(ordinal);
    }
    const EGLDisplay display = openDeviceDisplay(device);
    facts.usable = display != EGL_NO_DISPLAY;
    const char* vendor = facts.usable ? eglQueryString(display, EGL_VENDOR) : nullptr;
    facts.vendor = vendor != nullptr ? vendor : "";
    return facts;
}

std::string eglErrorName() {
    switch (eglGetError()) {
        case EGL_SUCCESS:
            return "no error";
        case EGL_NOT_INITIALIZED:
            return "EGL_NOT_INITIALIZED";
        case EGL_BAD_ALLOC:
            return "EGL_BAD_ALLOC";
        case EGL_BAD_ATTRIBUTE:
            return "EGL_BAD_ATTRIBUTE";
        case EGL_BAD_CONFIG:
            return "EGL_BAD_CONFIG";
        case EGL_BAD_CONTEXT:
            return "EGL_BAD_CONTEXT";
        case EGL_BAD_MATCH:
            return "EGL_BAD_MATCH";
        case EGL_BAD_PARAMETER:
            return "EGL_BAD_PARAMETER";
        default:
            return "an unknown EGL error";
    }
}

}  // namespace demolish::engine
