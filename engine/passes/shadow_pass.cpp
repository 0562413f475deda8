// SPDX-License-Identifier: Apache-2.0
// Orthographic, two regions side by side; depth clamp lets things between sun and region cast shadows too.
#include "engine/passes/shadow_pass.h"

namespace demolish::engine {
namespace {

constexpr GLint kRegion = 0;
constexpr float kEmptyDepth = 1.0f;

}  // namespace

ShadowPass::ShadowPass(const std::filesystem::path& shaders)
    : shaders_(shaders), body_(shaders, {"shadow.vert", "shadow.frag"}), eraser_(shaders, kEmptyDepth) {
    for (gl::Sampler* sampler : {&compare_, &plain_}) {
        sampler->set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);  // no tap leaves its region
        sampler->set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    compare_.set(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    compare_.set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    compare_.set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    compare_.set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    plain_.set(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    plain_.set(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

bool ShadowPass::holds(const ShadowScene& scene, int size) {
    if (map_.height() == size && scene == scene_) return true;
    scene_ = scene;
    return false;
}

void ShadowPass::begin(int size, bool erase_tiles) {
    if (map_.height() != size) {
        map_ = gl::Texture::make2d(GL_DEPTH_COMPONENT32F, kShadowRegions * size, size);
        framebuffer_ = gl::Framebuffer({}, &map_);
        eraser_.forget();
    }
    if (!erase_tiles) eraser_.forget();
    eraser_.erase(framebuffer_, map_);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(kShadowSlopes, kShadowSteps);
}

void ShadowPass::enter(int region, const SmallTriangles* small) {
    glViewport(region * map_.height(), 0, map_.height(), map_.height());
    body_.set(kRegion, region);
    region_ = region;
    if (small != nullptr) putSmall(*small);
}

void ShadowPass::drawBody(BodyGeometry& body, const FractureMesh& mesh, uint32_t hidden_looks,
                          bool with_looks, const NearFaces* near, const SeenList* seen) {
    const bool masked = with_looks && mesh.looks()->isMasked();
    body_.set(kHiddenLooks, hidden_looks);
    if (masked) {
        if (masked_.id() == 0)
            masked_ = gl::Program(shaders_, {"shadow.vert", "shadow_masked.frag"}, "#define LOOKS\n");
        masked_.set(kRegion, region_);
        masked_.set(kHiddenLooks, hidden_looks);
        masked_.use();
        body.drawExterior(mesh, seen);
    }
    body_.use();
    if (!masked) body.drawExterior(mesh, seen);
    body.drawInterior(body_, mesh, near, seen);
}

void ShadowPass::putSmall(const SmallTriangles& small) {
    const auto region = static_cast<size_t>(region_);
    const PixelBox& box = small.touched(region + 1);
    if (box.isEmpty()) return;
    const int size = map_.height();
    map_.uploadPart(region_ * size + box.left, box.low, box.width(), box.height(), GL_DEPTH_COMPONENT,
                    GL_FLOAT, small.depths(region).data() + box.low * size + box.left, size);
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
