// SPDX-License-Identifier: Apache-2.0
// Materials are drawn, light is computed afterwards; 32-bit float depth is what reversed depth needs.
#include "engine/render/render_targets.h"

#include <algorithm>
#include <bit>

namespace demolish::engine {

RenderTargets::RenderTargets(int width_px, int height_px, int sample_count)
    : width(width_px),
      height(height_px),
      samples(sample_count),
      material(gl::Texture::makeTarget(GL_RGBA8, width, height, samples)),
      normals(gl::Texture::makeTarget(GL_RGBA16, width, height, samples)),
      material_bits(gl::Texture::viewTarget(material, GL_R32UI, samples)),
      normal_bits(gl::Texture::viewTarget(normals, GL_RG32UI, samples)),
      depth(gl::Texture::makeTarget(GL_DEPTH_COMPONENT32F, width, height, samples)),
      display(gl::Texture::make2d(GL_RGBA8, width, height)),
      scene({&material, &normals}, &depth),
      depth_only({}, &depth),
      resolved({&display}, nullptr) {
    scene.bind();
    for (int i = 0; i < samples; ++i) {
        float position[2] = {0.5f, 0.5f};
        if (samples > 1) glGetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), position);
        sample_position[static_cast<size_t>(i)] = {position[0], position[1]};
    }
}

void RenderTargets::show(GLuint framebuffer) const {
    glBlitNamedFramebuffer(resolved.id(), framebuffer, 0, 0, width, height, 0, 0, width, height,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

bool fitTargets(std::optional<RenderTargets>& targets, const FrameView& view) {
    GLint max_samples = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
    const int wanted = std::clamp(view.samples, 1, std::min(4, max_samples));
    const int samples = static_cast<int>(std::bit_floor(static_cast<unsigned>(wanted)));
    if (targets && targets->fits(view.width, view.height, samples)) return false;
    targets.reset();  // both sets at once might not fit into a small GPU
    targets.emplace(view.width, view.height, samples);
    return true;
}

}  // namespace demolish::engine
