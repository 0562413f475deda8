// SPDX-License-Identifier: Apache-2.0
// Headless contexts: what they say of themselves, and living side by side.
#include <glad/gl.h>

#include "engine/gl/error.h"
#include "engine/platform/headless_context.h"
#include "tests/render/gl_fixture.h"

namespace demolish::engine::test {
namespace {

TEST(HeadlessContext, SaysWhatItIs) {
    const HeadlessContext context;
    const ContextInfo& info = context.info();
    EXPECT_FALSE(info.renderer.empty());
    EXPECT_FALSE(info.platform.empty());
    EXPECT_GE(info.max_samples, 4);
    EXPECT_TRUE(info.note.empty()) << "nothing was wished for that could be missing";
}

TEST(HeadlessContext, WishForAnAbsentCudaDeviceIsAnsweredWithTheRemedy) {
    HeadlessOptions options;
    options.cuda_device = 1000;
    const HeadlessContext context(options);
    EXPECT_NE(context.info().cuda_device, 1000);
    EXPECT_NE(context.info().note.find("1000"), std::string::npos);
    EXPECT_NE(context.info().note.find("__EGL_VENDOR_LIBRARY_FILENAMES"), std::string::npos);
}

TEST(HeadlessContext, TwoOfThemKeepTheirObjectsApart) {
    HeadlessContext first, second;
    GLuint buffer = 0;
    glCreateBuffers(1, &buffer);
    EXPECT_TRUE(glIsBuffer(buffer));
    first.makeCurrent();
    EXPECT_FALSE(glIsBuffer(buffer));
    second.makeCurrent();
    EXPECT_TRUE(glIsBuffer(buffer));
}

TEST(HeadlessContext, SoftwareCanBeAskedFor) {
    HeadlessOptions options;
    options.software_only = true;
    try {
        const HeadlessContext context(options);
        EXPECT_TRUE(context.info().software) << context.info().renderer;
    } catch (const gl::GlError& error) {
        GTEST_SKIP() << "no software renderer is installed here: " << error.what();
    }
}

TEST(EglDevices, AreListedInOrder) {
    const std::vector<EglDevice> devices = listEglDevices();
    for (size_t i = 0; i < devices.size(); ++i) EXPECT_EQ(devices[i].index, static_cast<int>(i));
    for (const EglDevice& device : devices) EXPECT_TRUE(!device.usable || !device.vendor.empty());
}

}  // namespace
}  // namespace demolish::engine::test
