// SPDX-License-Identifier: Apache-2.0
// One headless context and renderer for all tests of a program; making them anew for each test would be most
// of the time.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>

#include "engine/platform/gl_context.h"
#include "engine/render/renderer.h"

namespace demolish::engine::test {

/// The repository's shaders, or DEMOLISH_SHADERS where the tests have travelled.
std::filesystem::path shaderFolder();

class GlTest : public testing::Test {
  protected:
    static GlContext& context();
    static Renderer& renderer();
    void SetUp() override { context().makeCurrent(); }
};

}  // namespace demolish::engine::test
