// SPDX-License-Identifier: Apache-2.0
// The context has the debug flag, so that every GL mistake of a test run becomes a GlError.
#include "tests/render/gl_fixture.h"

#include <cstdlib>

#include "engine/platform/headless_context.h"

namespace demolish::engine::test {

std::filesystem::path shaderFolder() {
    const char* folder = std::getenv("DEMOLISH_SHADERS");
    return folder != nullptr ? std::filesystem::path(folder)
                             : std::filesystem::path(DEMOLISH_SOURCE_DIR) / "shaders";
}

GlContext& GlTest::context() {
    static HeadlessContext shared = [] {
        HeadlessOptions options;
        options.debug = true;
        return HeadlessContext(options);
    }();
    return shared;
}

Renderer& GlTest::renderer() {
    context();
    static Renderer shared(shaderFolder());
    return shared;
}

}  // namespace demolish::engine::test
