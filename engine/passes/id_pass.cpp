// SPDX-License-Identifier: Apache-2.0
// Reads back and so waits for the GPU: for clicks and tests, not for every frame.
#include "engine/passes/id_pass.h"

#include <algorithm>

namespace demolish::engine {

IdPass::IdPass(const std::filesystem::path& shaders) : body_(shaders, {"id.vert", "id.frag"}) {}

void IdPass::draw(const IdScene& scene, const FrameView& view) {
    if (ids_.width() != view.width || ids_.height() != view.height) {
        ids_ = gl::Texture::make2d(GL_R32UI, view.width, view.height);
        depth_ = gl::Texture::make2d(GL_DEPTH_COMPONENT32F, view.width, view.height);
        framebuffer_ = gl::Framebuffer({&ids_}, &depth_);
    }
    framebuffer_.bind();
    glViewport(0, 0, view.width, view.height);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glDepthFunc(GL_GEQUAL);
    const GLuint nothing[4] = {kBackgroundId, 0, 0, 0};
    const float far_depth = 0.0f;
    glClearBufferuiv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
    if (scene.mesh != nullptr && view.mode == ViewMode::kSurface) {
        body_.use();
        scene.body.drawExterior(*scene.mesh);
        scene.body.drawInterior(*scene.mesh);
    }
    if (scene.mesh != nullptr && view.mode == ViewMode::kParticles)
        scene.spheres.drawParticleIds(*scene.mesh);
    scene.spheres.drawSphereIds();
    scene.colliders.drawIds();
    if (scene.floor != nullptr) scene.floor->drawIds();
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

Pick IdPass::pick(const IdScene& scene, const FrameView& view, int x, int y) {
    const int row = view.height - 1 - y;
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, row, 1, 1);
    draw(scene, view);
    glDisable(GL_SCISSOR_TEST);
    Pick pick;
    float depth = 0.0f;
    glReadPixels(x, row, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &pick.fragment);
    glReadPixels(x, row, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    pick.hit = pick.fragment != kBackgroundId;
    if (!pick.hit) return pick;
    const Camera& camera = view.camera;
    const float range = camera.far_plane - camera.near_plane;
    const float along_axis = camera.near_plane * camera.far_plane / (camera.near_plane + depth * range);
    const Ray ray = pixelRay(camera, view.width, view.height, static_cast<float>(x), static_cast<float>(y));
    const glm::vec3 axis = camera.direction();
    const glm::vec3 position = ray.origin + ray.direction * (along_axis / glm::dot(ray.direction, axis));
    for (int i = 0; i < 3; ++i) pick.position[i] = position[i];
    return pick;
}

std::vector<uint32_t> IdPass::readAll(const IdScene& scene, const FrameView& view) {
    draw(scene, view);
    const size_t width = static_cast<size_t>(view.width);
    std::vector<uint32_t> ids(width * static_cast<size_t>(view.height));
    glReadPixels(0, 0, view.width, view.height, GL_RED_INTEGER, GL_UNSIGNED_INT, ids.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    for (int top = 0, bottom = view.height - 1; top < bottom; ++top, --bottom) {
        std::swap_ranges(ids.begin() + top * width, ids.begin() + (top + 1) * width,
                         ids.begin() + bottom * width);
    }
    return ids;
}

}  // namespace demolish::engine
