// SPDX-License-Identifier: Apache-2.0
// The chosen body in the picture: its box, arrows along the axes, a ring about the vertical; dragged by the
// mouse, on what lies below or along a handle. What is let go becomes a value of the shot.
#pragma once
#include <optional>

#include "app/panel/layout.h"
#include "app/session/shot_setup.h"
#include "engine/scene/camera.h"

namespace demolish {

class Gizmo {
  public:
    /// In every frame, before the camera looks at the mouse; `bodies` of the shot on screen. Acts while
    /// PanelState::arrange is on. True: the mouse is its own now.
    bool update(PanelContext& context, const BodyList& bodies, const engine::Camera& camera,
                const PictureArea& area);

  private:
    enum class Handle { kNone, kBody, kX, kY, kZ, kTurn };
    struct Sight;
    void take(PanelContext& context, const BodyList& bodies, const Sight& sight);
    void grabBody(const Shot& shot, const BodyList& bodies, size_t body, const Sight& sight);
    void drag(const Shot& shot, const BodyList& bodies, const Sight& sight);
    void letGo(PanelContext& context);
    Handle handleUnderMouse(const Sight& sight, const SceneBody& body, double height) const;
    void draw(const Shot& shot, const BodyList& bodies, size_t body, const Sight& sight) const;

    Handle held_ = Handle::kNone;
    bool moved_ = false;
    SceneBody before_, now_;  ///< of the body that is held
    size_t body_ = 0;
    glm::vec2 to_foot_{0};   ///< of the mouse's points, from the mouse to the foot of the body that is held
    glm::dvec3 grabbed_{0};  ///< m from the foot to what was seen there; x: rad or m along a handle
};

}  // namespace demolish
