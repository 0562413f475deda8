// SPDX-License-Identifier: Apache-2.0
// A picture of its own, made for bodies that glow: others pay nothing.
#include "engine/passes/glow_pass.h"

namespace demolish::engine {
namespace {

constexpr GLuint kUnit = 19;
constexpr GLfloat kNoGlow[4] = {0, 0, 0, 1};

}  // namespace

void GlowPass::draw(BodyGeometry& body, const FractureMesh& mesh, const RenderTargets& targets) {
    if (program_.id() == 0)
        program_ = gl::Program(shaders_, {"surface.vert", "glow.frag"}, "#define LOOKS\n");
    const bool fits = glow_.width() == targets.width && glow_.height() == targets.height &&
                      samples_ == targets.samples && depth_ == targets.depth.id();
    if (!fits) {
        glow_ = gl::Texture::makeTarget(GL_RGBA16F, targets.width, targets.height, targets.samples);
        framebuffer_ = gl::Framebuffer({&glow_}, &targets.depth);
        samples_ = targets.samples;
        depth_ = targets.depth.id();
    }
    glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 0, kNoGlow);
    framebuffer_.bind();
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    program_.use();
    const bool both_sides = mesh.looks()->isDoubleSided();
    if (both_sides) glDisable(GL_CULL_FACE);
    body.drawExterior(mesh);
    if (both_sides) glEnable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GEQUAL);
    targets.scene.bind();
}

void GlowPass::bind() const {
    glow_.bind(kUnit);
}

}  // namespace demolish::engine
