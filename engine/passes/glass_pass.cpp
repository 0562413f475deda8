// SPDX-License-Identifier: Apache-2.0
// A layer is peeled at twice the picture's width and height where the picture has four samples a pixel.
#include "engine/passes/glass_pass.h"

#include <array>
#include <cmath>
#include <string>

#include "engine/render/shown.h"

namespace demolish::engine {
namespace {

constexpr GLint kNoise = 0, kFirst = 1, kFrost = 1, kWalkNoise = 20, kScattered = 0;
constexpr GLuint kLayerUnit = 3, kOpaqueUnit = 7, kShadowUnit = 14, kSceneUnit = 15;
constexpr GLuint kCausticsUnit = 20;
constexpr float kNoEnd = -1000;  ///< shaders/common/glass_ends.glsl

int acrossFor(const RenderTargets& targets) {
    return targets.samples >= 4 ? 2 : 1;
}

std::string numbersFor(const RenderTargets& targets) {
    return "#define ACROSS " + std::to_string(acrossFor(targets)) + "\n";
}

constexpr float kEmptyDepth = 0;

}  // namespace

GlassPass::GlassPass(const std::filesystem::path& shaders, size_t task_room)
    : shaders_(shaders), task_room_(task_room), eraser_(shaders, kEmptyDepth) {}

bool GlassPass::readyToFind(const FractureMesh& mesh, const RenderTargets& targets) {
    const int across = acrossFor(targets);
    if (!GlassRaster::suits(mesh, targets, across)) return false;
    if (!raster_) raster_.emplace(shaders_, task_room_);
    raster_->prepare(targets, across);
    return true;
}

void GlassPass::makeShadowTargets(bool draft) {
    constexpr int kTexels = GlassRaster::kSumTexels;
    if (!shadow_sums_) {
        shadow_sums_ =
            gl::Texture::make2d(GL_RG32F, kTexels, kTexels, static_cast<int>(GlassRaster::kSumLevels));
        shadow_sums_.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
        shadow_target_ = gl::Framebuffer({&shadow_sums_}, nullptr);
    }
    if (draft || caustics_) return;
    shadow_ends_ = gl::Texture::make2d(GL_RG32F, kTexels, kTexels);
    shadow_ends_.setFilter(GL_LINEAR, GL_LINEAR);
    ends_target_ = gl::Framebuffer({&shadow_sums_, &shadow_ends_}, nullptr);
    caustics_.emplace(shaders_);
}

void GlassPass::castShadow(BodyGeometry& body, const FractureMesh& mesh, const glm::mat4& light_matrix,
                           const FrameView& view, bool finds) {
    const bool draft = view.quality == RenderQuality::kDraft;
    makeShadowTargets(draft);
    const SurfaceLook look = glassOf(view);
    const glm::vec4 bends(look.absorption[0], look.absorption[1], look.absorption[2], look.refraction_index);
    const bool bent = !draft && view.hasFloor();
    const ShadowKey key{mesh.version(), light_matrix, bends, look.frost, bent};
    if (key != shadow_key_) {
        shadow_key_ = key;
        const uint32_t hidden = hiddenUnless(true, looksOf(view));
        const float scattered = -std::log(1 - 0.9f * look.frost);
        if (finds)
            raster_->castSums(mesh, hidden, scattered, shadow_sums_, shadow_ends_);
        else
            drawShadow(body, mesh, hidden, scattered, !draft);
        if (bent) caustics_->cast(shadow_sums_, shadow_ends_);
    }
    shadow_sums_.bind(kShadowUnit);
    if (!draft) caustics_->light().bind(kCausticsUnit);
}

void GlassPass::drawShadow(BodyGeometry& body, const FractureMesh& mesh, uint32_t hidden, float scattered,
                           bool with_ends) {
    if (shadow_.id() == 0) shadow_ = gl::Program(shaders_, {"glass_shadow.vert", "glass_shadow.frag"});
    const gl::Framebuffer& target = with_ends ? ends_target_ : shadow_target_;
    constexpr std::array<float, 4> kNothing{}, kNoEnds{kNoEnd, kNoEnd, kNoEnd, kNoEnd};
    glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, kNothing.data());
    if (with_ends) glClearNamedFramebufferfv(target.id(), GL_COLOR, 1, kNoEnds.data());
    target.bind();
    glViewport(0, 0, GlassRaster::kSumTexels, GlassRaster::kSumTexels);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBlendEquationi(1, GL_MAX);
    shadow_.use();
    shadow_.set(kHiddenLooks, hidden);
    shadow_.set(kScattered, 0.0f);
    body.drawExterior(mesh);
    shadow_.set(kScattered, scattered);
    body.drawInterior(mesh);
    glBlendEquationi(1, GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glGenerateTextureMipmap(shadow_sums_.id());
}

GLuint GlassPass::scene(const RenderTargets& targets) {
    fit(targets);
    return scene_target_.id();
}

void GlassPass::fit(const RenderTargets& targets) {
    if (scene_ && scene_.width() == targets.width && scene_.height() == targets.height) return;
    scene_ = gl::Texture::make2d(GL_RGBA16F, targets.width, targets.height);
    scene_.setFilter(GL_LINEAR, GL_LINEAR);
    scene_.setWrap(GL_CLAMP_TO_EDGE);
    scene_target_ = gl::Framebuffer({&scene_}, nullptr);
}

void GlassPass::fitLayers(const RenderTargets& targets) {
    const int across = acrossFor(targets), width = across * targets.width, height = across * targets.height;
    if (depth_ && depth_.width() == width && depth_.height() == height) return;
    depth_ = gl::Texture::make2d(GL_DEPTH_COMPONENT32F, width, height);
    for (Layer& layer : layers_) {
        layer.texture = gl::Texture::make2d(GL_RG32UI, width, height);
        layer.framebuffer = gl::Framebuffer({&layer.texture}, &depth_);
    }
    depth_only_ = gl::Framebuffer({}, &depth_);
    eraser_.forget();
}

GlassPass::PeelPrograms& GlassPass::peelFor(const RenderTargets& targets) {
    PeelPrograms& programs = peel_[{targets.samples, acrossFor(targets)}];
    if (programs.exterior.id() != 0) return programs;
    const std::string defines =
        numbersFor(targets) + "#define SAMPLES " + std::to_string(targets.samples) + "\n";
    programs.exterior = gl::Program(shaders_, {"surface.vert", "glass_peel.frag"}, defines);
    programs.interior =
        gl::Program(shaders_, {"surface.vert", "glass_peel.frag"}, defines + "#define INTERIOR\n");
    return programs;
}

/// A computed clear takes a fiftieth of a drawn one where few multiprocessors draw.
void GlassPass::clearLayers() {
    if (clear_.id() == 0)
        clear_ =
            gl::Program(shaders_, {"glass_clear.comp"}, "#define LAYERS " + std::to_string(kLayers) + "\n");
    for (size_t k = 0; k < layers_.size(); ++k)
        glBindImageTexture(static_cast<GLuint>(k), layers_[k].texture.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                           GL_RG32UI);
    clear_.use();
    glDispatchCompute(gl::tilesAlong(depth_.width()), gl::tilesAlong(depth_.height()), 1);
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void GlassPass::peelLayer(size_t k, PeelPrograms& programs, BodyGeometry& body, const FractureMesh& mesh) {
    layers_[k].framebuffer.bind();
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_GREATER);
    // The first has none before it; another's texture stands in.
    layers_[k == 0 ? 1 : k - 1].texture.bind(kLayerUnit);
    for (gl::Program* program : {&programs.exterior, &programs.interior})
        program->set(kFirst, k == 0 ? 1 : 0);
    programs.exterior.use();
    body.drawExterior(mesh);
    programs.interior.use();
    body.drawInterior(mesh);
}

void GlassPass::peel(BodyGeometry& body, const FractureMesh& mesh, const FrameView& view,
                     const RenderTargets& targets) {
    fitLayers(targets);
    const std::vector<SurfaceLook> looks = looksOf(view);
    const SurfaceLook look = glassOf(view);
    PeelPrograms& programs = peelFor(targets);
    for (gl::Program* program : {&programs.exterior, &programs.interior}) {
        program->set(kNoise, glm::vec2(look.noise_scale, look.noise_strength));
        program->set(kHiddenLooks, hiddenUnless(true, looks));
    }
    const bool draft = view.quality == RenderQuality::kDraft;
    if (!draft) clearLayers();
    constexpr std::array<GLuint, 4> kNothing{};
    glEnable(GL_DEPTH_TEST);
    targets.depth.bind(kOpaqueUnit);
    for (size_t k = 0; k < layers_.size(); ++k) {
        if (draft) glClearNamedFramebufferuiv(layers_[k].framebuffer.id(), GL_COLOR, 0, kNothing.data());
        eraser_.erase(depth_only_, depth_);
        peelLayer(k, programs, body, mesh);
        // No layer touches more than the first.
        if (k == 0) eraser_.remember(depth_, 1);
    }
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
}

void GlassPass::find(const FractureMesh& mesh, const FrameView& view, const RenderTargets& targets) {
    raster_->find(mesh, targets, acrossFor(targets), hiddenUnless(true, looksOf(view)));
}

gl::Program& GlassPass::walkFor(const RenderTargets& targets, PictureKind kind, Walk how) {
    kind.samples = targets.samples;
    kind.glow = false;  // of what is opaque, which is lit already
    const int across = acrossFor(targets);
    gl::Program& program = walk_[{kind, across, how}];
    if (program.id() != 0) return program;
    std::string text = defines(kind) + "#define LAYERS " + std::to_string(kLayers) + "\n";
    if (how == Walk::kOverFound)
        text += "#define FOUND_FACES\n" + GlassRaster::defines(across);
    else
        text += numbersFor(targets);
    program = how == Walk::kDrawn
                  ? gl::Program(shaders_, {"touched_tiles.vert", "glass_walk.frag"}, text + "#define DRAFT\n")
                  : gl::Program(shaders_, {"glass_walk.comp"}, text);
    setTone(program, kind.tone);
    return program;
}

gl::Program& GlassPass::behindFor(const PictureKind& kind) {
    gl::Program& program = behind_[kind];
    if (program.id() == 0) {
        program = gl::Program(shaders_, {"whole_picture.vert", "glass_behind.frag"}, defines(kind));
        setTone(program, kind.tone);
    }
    return program;
}

void GlassPass::bindWalk(gl::Program& program, const RenderTargets& targets, const FrameView& view) {
    targets.depth.bind(kOpaqueUnit);
    scene_.bind(kSceneUnit);
    program.set(kFrost, glassOf(view).frost);
    program.use();
}

void GlassPass::bindLayers() const {
    for (size_t k = 0; k < layers_.size(); ++k) layers_[k].texture.bind(kLayerUnit + static_cast<GLuint>(k));
}

void GlassPass::walk(const RenderTargets& targets, const FrameView& view, PictureKind kind,
                     GLuint framebuffer) {
    gl::Program& walk = walkFor(targets, kind, Walk::kDrawn);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, targets.width, targets.height);
    scene_.bind(kSceneUnit);
    behindFor(kind).use();
    no_attributes_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    bindLayers();
    bindWalk(walk, targets, view);
    eraser_.touched().draw(walk);
}

void GlassPass::computeWalk(const FractureMesh* found, const RenderTargets& targets, const FrameView& view,
                            PictureKind kind, GLuint framebuffer) {
    const GLenum format = kind.radiance ? GL_RGBA16F : GL_RGBA8;
    const GLuint target = gl::writableTexture(framebuffer, targets.width, targets.height, format);
    gl::Program& program = walkFor(targets, kind, found != nullptr ? Walk::kOverFound : Walk::kComputed);
    if (found != nullptr) {
        const SurfaceLook look = glassOf(view);
        program.set(kWalkNoise, glm::vec2(look.noise_scale, look.noise_strength));
        raster_->bind(*found);
    } else {
        bindLayers();
    }
    bindWalk(program, targets, view);
    gl::computePicture(target != 0 ? target : targets.display.id(), format, targets.width, targets.height);
    if (target == 0) targets.show(framebuffer);
}

}  // namespace demolish::engine
