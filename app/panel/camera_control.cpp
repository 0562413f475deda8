// SPDX-License-Identifier: Apache-2.0
// Orbit, pan, dolly by every binding that people's hands know.
#include "app/panel/camera_control.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace demolish {
namespace {

constexpr float kOrbitPerPixel = 0.008f;  // rad
constexpr float kDollyPerPixel = 0.006f, kDollyPerNotch = 0.12f;
constexpr float kClickSlack = 4;  // px

enum class Drag { kNone, kOrbit, kPan, kDolly };

Drag dragOf(const ImGuiIO& io) {
    if (io.MouseDown[ImGuiMouseButton_Middle]) {
        if (io.KeyShift || io.KeyAlt) return Drag::kPan;
        return io.KeyCtrl ? Drag::kDolly : Drag::kOrbit;
    }
    if (io.MouseDown[ImGuiMouseButton_Right] && io.KeyAlt) return Drag::kDolly;
    if (io.MouseDown[ImGuiMouseButton_Left]) return Drag::kOrbit;
    return Drag::kNone;
}

bool inside(const ImGuiIO& io, const PictureArea& area) {
    const float x = io.MousePos.x * io.DisplayFramebufferScale.x,
                y = io.MousePos.y * io.DisplayFramebufferScale.y;
    return x >= static_cast<float>(area.x) && y >= 0 && x < static_cast<float>(area.x + area.width) &&
           y < static_cast<float>(area.height);
}

/// Of the picture, in the units of the mouse: what is dragged stays under the cursor.
float shorterSide(const ImGuiIO& io, const PictureArea& area) {
    return std::max(1.0f,
                    static_cast<float>(std::min(area.width, area.height)) / io.DisplayFramebufferScale.y);
}

bool anyButton(const bool (&buttons)[5]) {
    return buttons[0] || buttons[1] || buttons[2];
}

}  // namespace

std::optional<PicturePoint> CameraControl::update(engine::Camera& camera, const PictureArea& area) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool free = !io.WantCaptureMouse && inside(io, area);
    if (free && io.MouseWheel != 0) camera.dolly(std::exp(-kDollyPerNotch * io.MouseWheel));
    if (free && anyButton(io.MouseClicked)) {
        dragging_ = true;
        moved_ = false;
    }
    std::optional<PicturePoint> click;
    if (dragging_ && io.MouseReleased[ImGuiMouseButton_Left] && !moved_ && !io.KeyAlt && free)
        click = PicturePoint{static_cast<int>(io.MousePos.x * io.DisplayFramebufferScale.x) - area.x,
                             static_cast<int>(io.MousePos.y * io.DisplayFramebufferScale.y)};
    if (!anyButton(io.MouseDown)) dragging_ = false;
    if (!dragging_) return click;

    for (int button = 0; button < 3; ++button)
        if (io.MouseDown[button] && io.MouseDragMaxDistanceSqr[button] > kClickSlack * kClickSlack)
            moved_ = true;
    if (!moved_) return click;
    const ImVec2 delta = io.MouseDelta;
    const float side = shorterSide(io, area);
    switch (dragOf(io)) {
        case Drag::kOrbit:
            camera.orbit(-kOrbitPerPixel * delta.x, kOrbitPerPixel * delta.y);
            break;
        case Drag::kPan:
            camera.pan(-delta.x / side, delta.y / side);
            break;
        case Drag::kDolly:
            camera.dolly(std::exp(kDollyPerPixel * (delta.y - delta.x)));
            break;
        case Drag::kNone:
            break;
    }
    return click;
}

}  // namespace demolish
