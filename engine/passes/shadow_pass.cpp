// Orthographic, fitted to the scene's sphere; depth clamp lets things between sun and sphere cast shadows
// too.
#include "engine/passes/shadow_pass.h"

namespace demolish::engine {
namespace {

constexpr float kEmptyDepth = 1.0f;

}  // namespace

ShadowPass::ShadowPass(const std::filesystem::path& shaders)
    : body_(shaders, {"shadow.vert", "shadow.frag"}), eraser_(shaders, kEmptyDepth) {
    const float lit[4] = {1, 1, 1, 1};
    for (gl::Sampler* sampler : {&compare_, &plain_}) {
        sampler->set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        sampler->set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
        sampler->setBorder(lit);
    }
    compare_.set(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    compare_.set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    compare_.set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    compare_.set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    plain_.set(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    plain_.set(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void ShadowPass::begin(int size, bool erase_tiles) {
    if (map_.width() != size) {
        map_ = gl::Texture::make2d(GL_DEPTH_COMPONENT32F, size, size);
        framebuffer_ = gl::Framebuffer({}, &map_);
        eraser_.forget();
    }
    if (!erase_tiles) eraser_.forget();
    eraser_.erase(framebuffer_, map_);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.1f, 2.0f);
}

void ShadowPass::drawBody(BodyGeometry& body, const FractureMesh& mesh) {
    body_.use();
    body.drawExterior(mesh);
    body.drawInterior(mesh);
}

void ShadowPass::finish(bool erase_tiles) {
    if (erase_tiles) eraser_.remember(map_, 1);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
}

void ShadowPass::bindMap() const {
    map_.bind(0);
    map_.bind(1);
    compare_.bind(0);
    plain_.bind(1);
}

void ShadowPass::unbindMap() {
    glBindSampler(0, 0);
    glBindSampler(1, 0);
}

}  // namespace demolish::engine
