// SPDX-License-Identifier: Apache-2.0
// By the same text that colours the particles.
#include "engine/render/colour_ramp.h"

#include "engine/gl/error.h"
#include "engine/gl/framebuffer.h"
#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"

namespace demolish::engine {
namespace {

constexpr int kTexels = 256;
constexpr GLint kWidth = 0;

}  // namespace

ColourRamp::ColourRamp(const std::filesystem::path& shader_folder)
    : texture_(gl::Texture::make2d(GL_RGBA8, kTexels, 1)) {
    texture_.setFilter(GL_LINEAR, GL_LINEAR);
    texture_.setWrap(GL_CLAMP_TO_EDGE);
    const gl::Framebuffer target({&texture_}, nullptr);
    const gl::VertexArray no_attributes;
    gl::Program program(shader_folder, {"whole_picture.vert", "colour_ramp.frag"});
    program.set(kWidth, static_cast<float>(kTexels));
    program.use();
    target.bind();
    glViewport(0, 0, kTexels, 1);
    no_attributes.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray(0);
    glUseProgram(0);
    gl::throwIfError("Drawing the colour scale");
}

}  // namespace demolish::engine
