// SPDX-License-Identifier: Apache-2.0
// Optical depths add up, so that puffs need no order: their light is a mean, weighted by depth.
#include "engine/passes/dust_pass.h"

#include <string>

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLint kDust = 0, kPixels = 1;
constexpr GLuint kSolidUnit = 4, kSumUnit = 12, kDustShadowUnit = 11;
/// Of the picture's sides; half size is not told from full. As shaders/common/dust_over.glsl.
constexpr int kFullPart = 2, kDraftPart = 4;
constexpr int kShadowTexels = 512;
/// m: wavelength of the lumps, in first wavelengths of the shading noise (a fifth of the spacing).
constexpr float kLumpWaves = 22;

void beginSums() {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
}

}  // namespace

DustPass::DustPass(const std::filesystem::path& shaders)
    : shaders_(shaders),
      shadows_(shaders, {"dust_shadow.vert", "dust_shadow.frag"}),
      nothing_(gl::Texture::make2d(GL_RG16F, 1, 1)) {
    const float nothing[2] = {0, 0};
    glClearTexImage(nothing_.id(), 0, GL_RG, GL_FLOAT, nothing);
}

gl::Program& DustPass::puffsFor(const RenderTargets& targets, bool full) {
    PictureKind kind = kind_;
    kind.samples = targets.samples;
    gl::Program& program = puffs_[{full, kind}];
    if (program.id() == 0)
        program =
            gl::Program(shaders_, {"dust.vert", "dust.frag"}, defines(kind) + (full ? "#define FULL\n" : ""));
    return program;
}

void DustPass::fit(int width, int height) {
    if (sums_ && sums_->texture.width() == width && sums_->texture.height() == height) return;
    gl::Texture texture = gl::Texture::make2d(GL_RGBA16F, width, height);
    texture.setFilter(GL_LINEAR, GL_LINEAR);
    sums_.emplace();
    sums_->texture = std::move(texture);
    sums_->framebuffer = gl::Framebuffer({&sums_->texture}, nullptr);
}

void DustPass::run(const gl::Program& program, const FractureMesh& mesh, const Sums& sums) {
    const float nothing[4] = {0, 0, 0, 0};
    program.use();  // first: some drivers hold the last pass's program against the shadow map as they clear
    glClearNamedFramebufferfv(sums.framebuffer.id(), GL_COLOR, 0, nothing);
    sums.framebuffer.bind();
    glViewport(0, 0, sums.texture.width(), sums.texture.height());
    bindStorage(StorageBinding::kPuffs, mesh.stream(StreamId::kPuffs));
    no_attributes_.bind();
    mesh.drawEffect(kPuffCommand, GL_TRIANGLE_STRIP);
}

void DustPass::castShadows(const FractureMesh* mesh) {
    if (mesh == nullptr) return nothing_.bind(kDustShadowUnit);
    if (!shadow_sums_) {
        shadow_sums_.emplace();
        shadow_sums_->texture = gl::Texture::make2d(GL_RG16F, kShadowTexels, kShadowTexels);
        shadow_sums_->texture.setFilter(GL_LINEAR, GL_LINEAR);
        shadow_sums_->framebuffer = gl::Framebuffer({&shadow_sums_->texture}, nullptr);
    }
    beginSums();
    run(shadows_, *mesh, *shadow_sums_);
    glDisable(GL_BLEND);
    shadow_sums_->texture.bind(kDustShadowUnit);
}

void DustPass::addPuffs(const FractureMesh& mesh, const FrameView& view, gl::Program& program, int part) {
    const auto& colour = view.look.dust_colour;
    program.set(kDust, glm::vec4(colour[0], colour[1], colour[2], 1 / (kLumpWaves * view.look.noise_scale)));
    program.set(kPixels, static_cast<float>(part));
    run(program, mesh, *sums_);
}

void DustPass::addUp(const FractureMesh* mesh, const FrameView& view, const RenderTargets& targets,
                     const gl::Texture* nearest_depth) {
    if (mesh == nullptr) return nothing_.bind(kSumUnit);
    const bool full = nearest_depth != nullptr;
    const int part = full ? kFullPart : kDraftPart;
    fit((targets.width + part - 1) / part, (targets.height + part - 1) / part);
    beginSums();
    (full ? *nearest_depth : targets.depth).bind(kSolidUnit);
    addPuffs(*mesh, view, puffsFor(targets, full), part);
    glDisable(GL_BLEND);
    sums_->texture.bind(kSumUnit);
}

}  // namespace demolish::engine
