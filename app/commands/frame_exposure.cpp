// SPDX-License-Identifier: Apache-2.0
// Many pictures on one film, each of another moment and through another point of the lens.
#include "app/commands/frame_exposure.h"

#include "app/session/data_folder.h"

namespace demolish {
namespace {

/// Each picture is of another part of a pixel: that is what samples are for.
constexpr uint32_t kEnoughForEdges = 8;

/// `moment`: 0 before, 1 after.
engine::FrameView viewBetween(const engine::FrameView& before, const engine::FrameView& after, float moment) {
    engine::FrameView view = after;
    view.camera.eye = glm::mix(before.camera.eye, after.camera.eye, moment);
    view.camera.target = glm::mix(before.camera.target, after.camera.target, moment);
    view.camera.up = glm::mix(before.camera.up, after.camera.up, moment);
    for (size_t i = 0; i < view.colliders.size() && i < before.colliders.size(); ++i) {
        const engine::ColliderDraw& from = before.colliders[i];
        engine::ColliderDraw& to = view.colliders[i];
        to.position = glm::mix(from.position, to.position, moment);
        to.half_size = glm::mix(from.half_size, to.half_size, moment);
        to.rotation = glm::slerp(from.rotation, to.rotation, moment);
    }
    return view;
}

}  // namespace

void addPicture(engine::Film& film, engine::Renderer& renderer, const engine::FractureMesh* mesh,
                std::span<const engine::SphereDraw> spheres, const engine::FrameView& picture) {
    renderer.draw(mesh, spheres, picture, film.framebuffer());
    film.add();
}

void FrameExposure::remember(const Session& session, const engine::Lens& lens) {
    if (lens.shutter <= 0) return;
    if (!motion_) motion_ = std::make_unique<engine::MotionBetween>(dataFolder() / "shaders");
    if (session.mesh() != nullptr) motion_->remember(*session.mesh());
    spheres_before_ = session.spheres();
}

std::vector<engine::SphereDraw> FrameExposure::spheresAt(const Session& session, float moment) const {
    std::vector<engine::SphereDraw> spheres = session.spheres();
    for (size_t i = 0; i < spheres.size() && i < spheres_before_.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const float before = spheres_before_[i].position[axis];
            spheres[i].position[axis] = before + moment * (spheres[i].position[axis] - before);
        }
    return spheres;
}

void FrameExposure::draw(Session& session, const engine::FrameView& view, const engine::FrameView& before,
                         double frame_s, const engine::Lens& lens, unsigned framebuffer) {
    const uint32_t pictures = engine::picturesOf(lens);
    if (pictures == 1 && lens.aperture <= 0 && lens.shutter <= 0 && !view.transparent)
        return renderer_.draw(session.mesh(), session.spheres(), view, framebuffer);
    if (!film_) film_ = std::make_unique<engine::Film>(dataFolder() / "shaders");
    film_->begin(view.width, view.height);
    const auto seconds = static_cast<float>(frame_s);
    for (uint32_t i = 0; i < pictures; ++i) {
        const float moment = engine::pictureMoment(lens, i, pictures);
        engine::FrameView picture = engine::pictureView(viewBetween(before, view, moment), lens, i, pictures);
        picture.opening = engine::pictureOpening(lens, seconds, i, pictures);
        if (pictures >= kEnoughForEdges) picture.samples = 1;
        if (motion_ && session.mesh() != nullptr) motion_->place(*session.mesh(), moment, seconds);
        addPicture(*film_, renderer_, session.mesh(),
                   motion_ ? spheresAt(session, moment) : session.spheres(), picture);
    }
    if (motion_ && session.mesh() != nullptr) motion_->restore(*session.mesh());
    film_->develop(view.lighting, framebuffer);
}

}  // namespace demolish
