// SPDX-License-Identifier: Apache-2.0
// EGL displays: listing devices, opening a display on one of them, saying what went wrong in words.
#pragma once
#include <glad/egl.h>

#include <string>
#include <vector>

#include "engine/platform/headless_context.h"

namespace demolish::engine {

/// Loads EGL itself, without a display. Throws gl::GlError when libEGL is missing.
void loadEgl();

std::vector<EGLDeviceEXT> queryEglDevices();

/// Initialised display of a device, or EGL_NO_DISPLAY. Displays are shared by all users of the process and
/// stay open.
EGLDisplay openDeviceDisplay(EGLDeviceEXT device);
/// Mesa's surfaceless platform, or EGL_NO_DISPLAY.
EGLDisplay openSurfacelessDisplay();

/// Facts of one device; opens its display.
EglDevice describeEglDevice(EGLDeviceEXT device, int index);

/// "EGL_BAD_MATCH" and the like, of the last EGL call.
std::string eglErrorName();

}  // namespace demolish::engine
