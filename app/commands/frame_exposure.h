// SPDX-License-Identifier: Apache-2.0
// Takes a frame as a camera does: through a lens, for as long as its shutter is open.
#pragma once
#include <memory>
#include <vector>

#include "app/session/session.h"
#include "engine/render/film.h"
#include "engine/render/motion_between.h"
#include "engine/render/renderer.h"
#include "engine/scene/lens.h"

namespace demolish {

class FrameExposure {
  public:
    explicit FrameExposure(engine::Renderer& renderer) : renderer_(renderer) {}
    /// Call before a frame that is drawn with an open shutter is simulated.
    void remember(const Session& session, const engine::Lens& lens);
    /// Draws the present frame, `frame_s` seconds after the frame before, while whose exposure camera and
    /// colliders come from where `before`, the same view at the frame before, has them; the session's bodies
    /// stay where they are.
    void draw(Session& session, const engine::FrameView& view, const engine::FrameView& before,
              double frame_s, const engine::Lens& lens, unsigned framebuffer);

  private:
    std::vector<engine::SphereDraw> spheresAt(const Session& session, float moment) const;
    engine::Renderer& renderer_;
    std::unique_ptr<engine::Film> film_;  ///< made when first needed, as the next
    std::unique_ptr<engine::MotionBetween> motion_;
    std::vector<engine::SphereDraw> spheres_before_;
};

/// Adds the film's next picture of what the session shows.
void addPicture(engine::Film& film, engine::Renderer& renderer, const engine::FractureMesh* mesh,
                std::span<const engine::SphereDraw> spheres, const engine::FrameView& picture);

}  // namespace demolish
