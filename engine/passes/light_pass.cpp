// SPDX-License-Identifier: Apache-2.0
// A compute pass: on data-centre GPUs only few multiprocessors draw, but all of them compute; and a pixel is
// lit once, however many triangles were drawn over it.
#include "engine/passes/light_pass.h"

#include "engine/passes/surface_pass.h"
#include "engine/surroundings/own_surroundings.h"

namespace demolish::engine {
namespace {

constexpr GLint kSamplePosition = 1, kBodyMaterial = 8;
constexpr GLuint kMaterialUnit = 3, kNormalUnit = 4, kDepthUnit = 5, kOcclusionUnit = 6;

/// Enough to fill any GPU; each goes on to further pixels.
constexpr GLuint kFoundGroups = 16384;

void bindInputs(const RenderTargets& targets) {
    targets.material_bits.bind(kMaterialUnit);
    targets.normal_bits.bind(kNormalUnit);
    targets.depth.bind(kDepthUnit);
}

}  // namespace

LightPass::LightPass(const std::filesystem::path& shaders) : shaders_(shaders) {}

void LightPass::prepare(const FrameView& view, const PictureKind& kind, bool with_looks) {
    kind_ = kind;
    with_looks_ = with_looks;
    texture_ = view.look.texture;
    const bool above_floor = view.hasFloor() && view.camera.eye.y > 0;
    surroundings_.show(view.lighting.surroundings ? view.lighting.surroundings : usualSurroundings(),
                       above_floor && view.lighting.floor != FloorMaterial::kShadow);
    surroundings_.bind();
}

gl::Program& LightPass::programFor(const RenderTargets& targets, Way way) {
    PictureKind kind = kind_;
    kind.samples = targets.samples;
    kind.looks = with_looks_ && way == Way::kFound;
    kind.glow = kind.glow && way != Way::kEmpty;
    const SolidTexture texture = way == Way::kFound ? texture_ : SolidTexture::kNone;
    gl::Program& program = programs_[{way, texture, kind}];
    if (program.id() != 0) return program;
    if (way == Way::kDrawn)
        program = gl::Program(shaders_, {"whole_picture.vert", "light.frag"},
                              defines(kind) + "#define SHADOW_DRAFT\n");
    else
        program = gl::Program(shaders_,
                              {way == Way::kComputed ? "light.comp"
                               : way == Way::kEmpty  ? "light_empty.comp"
                                                     : "light_found.comp"},
                              defines(kind) + textureDefine(texture));
    setTone(program, kind.tone);
    for (int i = 0; i < targets.samples; ++i)
        program.set(kSamplePosition + i, targets.sample_position[static_cast<size_t>(i)]);
    return program;
}

void LightPass::compute(const RenderTargets& targets, const gl::Texture& occlusion, GLuint picture) {
    programFor(targets, Way::kComputed).use();
    bindInputs(targets);
    occlusion.bind(kOcclusionUnit);
    gl::computePicture(picture, pictureFormat(), targets.width, targets.height);
}

void LightPass::computeFound(const RenderTargets& targets, const gl::Texture& occlusion,
                             const SurfaceLook& look, GLuint picture) {
    occlusion.bind(kOcclusionUnit);
    programFor(targets, Way::kEmpty).use();
    gl::computePicture(picture, pictureFormat(), targets.width, targets.height);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    gl::Program& program = programFor(targets, Way::kFound);
    setBodyMaterial(program, kBodyMaterial, with_looks_ ? withoutCoat(look) : look);
    program.use();
    glDispatchCompute(kFoundGroups, 1, 1);
    glMemoryBarrier(gl::kPictureBarriers);
}

void LightPass::draw(const RenderTargets& targets, GLuint framebuffer) {
    programFor(targets, Way::kDrawn).use();
    bindInputs(targets);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, targets.width, targets.height);
    no_attributes_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace demolish::engine
