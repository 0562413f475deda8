// SPDX-License-Identifier: Apache-2.0
// Owning GL objects: contents arrive, ownership moves, mistakes are named.
#include <algorithm>
#include <array>
#include <fstream>
#include <numeric>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/gl/error.h"
#include "engine/gl/pass_clock.h"
#include "engine/gl/program.h"
#include "engine/gl/shader_source.h"
#include "engine/gl/sync.h"
#include "tests/render/gl_fixture.h"

namespace demolish::engine::test {
namespace {

class GlObjects : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        folder_ = std::filesystem::path(testing::TempDir()) / "demolish_shaders";
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    std::filesystem::path folder_;
};

TEST_F(GlObjects, BufferKeepsWhatWasUploaded) {
    std::array<uint32_t, 64> sent, received{};
    std::iota(sent.begin(), sent.end(), 5u);
    gl::Buffer buffer = gl::Buffer::resizable(16);
    buffer.resize(sizeof(sent));
    buffer.upload(std::as_bytes(std::span(sent)));
    buffer.download(std::as_writable_bytes(std::span(received)));
    EXPECT_EQ(sent, received);
}

/// Large and several, as those of a mesh: there a driver has lost what came after zeros.
TEST_F(GlObjects, ZerosAreThereBeforeWhatIsUploadedNext) {
    constexpr size_t kWords = 250'000, kUploaded = 60'000;
    std::vector<uint32_t> sent(kUploaded), received(kWords);
    std::iota(sent.begin(), sent.end(), 1u);
    std::vector<gl::Buffer> buffers;
    for (int i = 0; i < 8; ++i) buffers.push_back(gl::Buffer::zeros(kWords * sizeof(uint32_t)));
    for (gl::Buffer& buffer : buffers) buffer.upload(std::as_bytes(std::span(sent)));
    for (const gl::Buffer& buffer : buffers) {
        buffer.download(std::as_writable_bytes(std::span(received)));
        EXPECT_TRUE(std::equal(sent.begin(), sent.end(), received.begin()));
        EXPECT_EQ(std::count(received.begin() + kUploaded, received.end(), 0u), kWords - kUploaded);
    }
}

TEST_F(GlObjects, MovedBufferLeavesNothingBehind) {
    gl::Buffer first = gl::Buffer::immutable(16);
    const GLuint id = first.id();
    const gl::Buffer second = std::move(first);
    EXPECT_EQ(second.id(), id);
    EXPECT_FALSE(static_cast<bool>(first));  // NOLINT: the moved-from state is what is tested
    EXPECT_TRUE(glIsBuffer(id));
}

TEST_F(GlObjects, DestroyedBufferIsGone) {
    GLuint id = 0;
    {
        const gl::Buffer buffer = gl::Buffer::immutable(16);
        id = buffer.id();
    }
    EXPECT_FALSE(glIsBuffer(id));
}

TEST_F(GlObjects, DriverErrorsBecomeExceptions) {
    glBindTexture(GL_TRIANGLES, 0);
    EXPECT_THROW(gl::throwIfError("Test"), gl::GlError);
    EXPECT_NO_THROW(gl::throwIfError("Test"));
}

TEST_F(GlObjects, ShaderErrorNamesTheIncludedFileAndItsLine) {
    write("good.glsl", "float twice(float x) { return 2.0 * x; }\n");
    write("bad.glsl", "// first line\nfloat broken( { return 1.0; }\n");
    write("test.comp",
          "#version 450 core\n#include \"good.glsl\"\n#include \"bad.glsl\"\n"
          "layout(local_size_x = 1) in;\nvoid main() {}\n");
    try {
        gl::Program program(folder_, {"test.comp"});
        FAIL() << "compiled";
    } catch (const gl::GlError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("test.comp"), std::string::npos) << text;
        EXPECT_NE(text.find("2=bad.glsl"), std::string::npos) << text;
        // Mesa writes file:line, NVIDIA file(line).
        EXPECT_TRUE(text.find("2:2") != std::string::npos || text.find("2(2)") != std::string::npos) << text;
    }
}

TEST_F(GlObjects, IncludesAreTakenOnceAndDefinesFollowTheVersion) {
    write("chunk.glsl", "float chunk() { return VALUE; }\n");
    write("test.comp",
          "#version 450 core\n#include \"chunk.glsl\"\n#include \"chunk.glsl\"\n"
          "layout(local_size_x = 1) in;\nvoid main() {}\n");
    EXPECT_EQ(gl::loadShaderSource(folder_, "test.comp").files.size(), 2u);
    EXPECT_NO_THROW(gl::Program(folder_, {"test.comp"}, "#define VALUE 1.0\n"));
}

/// Only the compiler knows which parts are skipped.
TEST_F(GlObjects, WhatASkippedPartIncludesIsThereBelow) {
    write("chunk.glsl", "float chunk() { return 1.0; }\n");
    write("user.glsl", "#include \"chunk.glsl\"\nfloat use() { return chunk(); }\n");
    write("test.comp",
          "#version 450 core\n#ifdef ABSENT\n#include \"chunk.glsl\"\n#endif\n#include \"user.glsl\"\n"
          "#include \"chunk.glsl\"\nlayout(local_size_x = 1) in;\nvoid main() {}\n");
    EXPECT_NO_THROW(gl::Program(folder_, {"test.comp"}));
    EXPECT_NO_THROW(gl::Program(folder_, {"test.comp"}, "#define ABSENT\n"));
}

TEST_F(GlObjects, MissingShaderIsNamed) {
    try {
        gl::loadShaderSource(folder_, "absent.frag");
        FAIL() << "found";
    } catch (const gl::GlError& error) {
        EXPECT_NE(std::string(error.what()).find("absent.frag"), std::string::npos);
    }
}

TEST_F(GlObjects, AFenceThatCannotBeWaitedForIsAnError) {
    const gl::Sync fence = gl::Sync::fence();
    EXPECT_TRUE(gl::Sync().wait(0)) << "no fence";
    const PFNGLCLIENTWAITSYNCPROC driver = glad_glClientWaitSync;
    glad_glClientWaitSync = [](GLsync, GLbitfield, GLuint64) -> GLenum { return GL_WAIT_FAILED; };
    EXPECT_THROW(fence.wait(0), gl::GlError);
    glad_glClientWaitSync = driver;
    glFinish();
    EXPECT_TRUE(fence.wait(1'000'000'000));
}

TEST_F(GlObjects, ClockReportsEachPassAfterAFewFrames) {
    gl::PassClock clock;
    gl::Buffer buffer = gl::Buffer::resizable(1 << 20);
    const std::vector<std::byte> zeros(buffer.size());
    EXPECT_EQ(clock.lastMs(), 0.0);
    EXPECT_TRUE(clock.lastPasses().empty());
    for (int frame = 0; frame < 6; ++frame) {
        clock.begin();
        buffer.upload(zeros);
        clock.mark("first");
        if (frame > 2) clock.mark("second");
        clock.end();
    }
    glFinish();
    EXPECT_GT(clock.lastMs(), 0.0);
    EXPECT_LT(clock.lastMs(), 1e4);
    ASSERT_EQ(clock.lastPasses().size(), 2u);
    EXPECT_STREQ(clock.lastPasses()[0].name, "first");
    EXPECT_STREQ(clock.lastPasses()[1].name, "second");
    EXPECT_GE(clock.lastPasses()[1].ms, 0.0);
}

}  // namespace
}  // namespace demolish::engine::test
