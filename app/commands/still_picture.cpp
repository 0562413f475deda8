// SPDX-License-Identifier: Apache-2.0
// The first picture of a still is the window's usual one; those of the film follow.
#include "app/commands/still_picture.h"

#include <algorithm>

#include "app/commands/frame_exposure.h"
#include "app/session/data_folder.h"
#include "engine/render/fracture_mesh.h"

namespace demolish {
namespace {

constexpr uint32_t kFinest = 64;

}  // namespace

bool StillPicture::isAsBefore(uint64_t version, std::span<const engine::SphereDraw> spheres,
                              const engine::FrameView& view, const engine::Lens& lens) const {
    return version == version_ && view == view_ && lens == lens_ &&
           std::equal(spheres.begin(), spheres.end(), spheres_.begin(), spheres_.end());
}

void StillPicture::draw(const engine::FractureMesh* mesh, std::span<const engine::SphereDraw> spheres,
                        const engine::FrameView& view, const engine::Lens& lens, bool moves,
                        unsigned framebuffer) {
    const uint64_t version = mesh != nullptr ? mesh->version() : 0;
    if (moves || !isAsBefore(version, spheres, view, lens)) {
        version_ = version;
        view_ = view;
        lens_ = lens;
        spheres_.assign(spheres.begin(), spheres.end());
        is_exposed_ = false;
        return renderer_.draw(mesh, spheres, view, framebuffer);
    }
    if (!film_) film_ = std::make_unique<engine::Film>(dataFolder() / "shaders");
    if (!is_exposed_) film_->begin(view.width, view.height);
    is_exposed_ = true;
    const auto next = static_cast<uint32_t>(film_->pictures());
    if (next < kFinest)
        addPicture(*film_, renderer_, mesh, spheres, engine::pictureView(view, lens, next, kFinest));
    film_->develop(view.lighting, framebuffer);
}

}  // namespace demolish
