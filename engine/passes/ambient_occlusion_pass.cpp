// SPDX-License-Identifier: Apache-2.0
// Three compute steps: reduce depth, gather horizons, blur.
#include "engine/passes/ambient_occlusion_pass.h"

#include <string>

namespace demolish::engine {
namespace {

constexpr GLint kReach = 0;
constexpr float kReachPerSceneRadius = 0.16f;

void dispatch(const gl::Texture& result, GLenum format) {
    glBindImageTexture(0, result.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, format);
    glDispatchCompute((result.width() + 7) / 8, (result.height() + 7) / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace

AmbientOcclusionPass::AmbientOcclusionPass(const std::filesystem::path& shaders)
    : shaders_(shaders),
      gather_(shaders, {"occlusion_gather.comp"}),
      blur_(shaders, {"occlusion_blur.comp"}) {}

gl::Program& AmbientOcclusionPass::reduceFor(int samples, bool found) {
    gl::Program& program = reduce_[{samples, found, with_colliders_}];
    if (program.id() == 0)
        program = gl::Program(shaders_, {"occlusion_depth.comp"},
                              "#define SAMPLES " + std::to_string(samples) +
                                  (found ? "\n#define COMPUTED\n" : "\n") +
                                  (with_colliders_ ? "#define COLLIDERS\n" : ""));
    return program;
}

void AmbientOcclusionPass::resize(int width, int height) {
    if (depth_.width() == width && depth_.height() == height) return;
    depth_ = gl::Texture::make2d(GL_R32F, width, height);
    raw_ = gl::Texture::make2d(GL_RG16F, width, height);
    blurred_ = gl::Texture::make2d(GL_RG32F, width, height);
}

const gl::Texture& AmbientOcclusionPass::run(const RenderTargets& targets, float scene_radius, bool found) {
    resize((targets.width + 1) / 2, (targets.height + 1) / 2);
    reduceFor(targets.samples, found).use();
    if (!found) targets.depth.bind(0);
    dispatch(depth_, GL_R32F);
    gather_.set(kReach, kReachPerSceneRadius * scene_radius);
    gather_.use();
    depth_.bind(0);
    dispatch(raw_, GL_RG16F);
    blur_.use();
    depth_.bind(0);
    raw_.bind(1);
    dispatch(blurred_, GL_RG32F);
    return blurred_;
}

}  // namespace demolish::engine
