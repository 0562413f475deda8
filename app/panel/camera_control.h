// SPDX-License-Identifier: Apache-2.0
// Mouse in the picture: Blender's and Maya's camera bindings at once, and the click that shoots.
#pragma once
#include <optional>

#include "app/panel/layout.h"
#include "engine/scene/camera.h"

namespace demolish {

/// A point of the picture, px from its top left.
struct PicturePoint {
    int x = 0, y = 0;
};

class CameraControl {
  public:
    /// Reads this frame's mouse; moves the camera. A left click that was no drag is returned.
    std::optional<PicturePoint> update(engine::Camera& camera, const PictureArea& area);

  private:
    bool dragging_ = false;  ///< a button went down inside the picture
    bool moved_ = false;     ///< and the mouse went farther than a click allows
};

}  // namespace demolish
