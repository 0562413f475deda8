// SPDX-License-Identifier: Apache-2.0
#include "app/panel/gizmo.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "app/session/placing.h"
#include "app/session/shot_geometry.h"

namespace demolish {
namespace {

constexpr double kArrowShare = 0.13;     // of the distance from the eye: as long on screen wherever it is
constexpr double kRingShare = 0.075;     // its radius
constexpr float kReach = 8, kSlack = 3;  // px: that near is on a handle; that far is a drag
constexpr int kRingParts = 48;
constexpr std::array<glm::dvec3, 3> kAxes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};

float distanceToLine(const ImVec2& p, const ImVec2& a, const ImVec2& b) {
    const float x = b.x - a.x, y = b.y - a.y, length2 = std::max(x * x + y * y, 1e-6f);
    const float t = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length2, 0.0f, 1.0f);
    return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

}  // namespace

/// The picture in the coordinates of the mouse, and the ray under it.
struct Gizmo::Sight {
    const engine::Camera& camera;
    ImVec2 corner, size;
    glm::mat4 to_picture;
    engine::Ray ray;
    ImVec2 mouse, scale;

    Sight(const engine::Camera& from, const PictureArea& area) : camera(from) {
        const ImGuiIO& io = ImGui::GetIO();
        scale = io.DisplayFramebufferScale;
        corner = ImVec2(static_cast<float>(area.x) / scale.x, static_cast<float>(area.y) / scale.y);
        size = ImVec2(static_cast<float>(area.width) / scale.x, static_cast<float>(area.height) / scale.y);
        to_picture = camera.projection(size.x / size.y) * camera.view();
        mouse = io.MousePos;
        ray = rayThrough(mouse);
    }
    engine::Ray rayThrough(const ImVec2& point) const {
        return engine::pixelRay(camera, static_cast<int>(size.x * scale.x),
                                static_cast<int>(size.y * scale.y), (point.x - corner.x) * scale.x,
                                (point.y - corner.y) * scale.y);
    }
    bool holdsMouse() const {
        return !ImGui::GetIO().WantCaptureMouse && mouse.x >= corner.x && mouse.y >= corner.y &&
               mouse.x < corner.x + size.x && mouse.y < corner.y + size.y;
    }
    /// None behind the eye.
    std::optional<ImVec2> at(const glm::dvec3& point) const {
        const glm::vec4 p = to_picture * glm::vec4(glm::vec3(point), 1);
        if (!(p.w > 1e-6f)) return std::nullopt;
        return ImVec2(corner.x + (0.5f + 0.5f * p.x / p.w) * size.x,
                      corner.y + (0.5f - 0.5f * p.y / p.w) * size.y);
    }
    double distance(const glm::dvec3& point) const { return glm::distance(point, glm::dvec3(camera.eye)); }
    /// Of the point of the line that the ray comes nearest to.
    double along(const glm::dvec3& foot, const glm::dvec3& axis) const {
        const glm::dvec3 way = glm::normalize(glm::dvec3(ray.direction)),
                         from = foot - glm::dvec3(ray.origin);
        const double b = glm::dot(axis, way), parting = 1 - b * b;
        if (parting < 1e-6) return 0;
        return (b * glm::dot(way, from) - glm::dot(axis, from)) / parting;
    }
    /// rad about the vertical, where the ray meets the level of the foot; none beside it.
    std::optional<double> angle(const glm::dvec3& foot) const {
        const glm::dvec3 way(ray.direction), from(ray.origin);
        const double t = std::abs(way.y) > 1e-9 ? (foot.y - from.y) / way.y : -1;
        if (!(t > 0)) return std::nullopt;
        const glm::dvec3 at = from + t * way - foot;
        return std::atan2(-at.z, at.x);
    }
};

Gizmo::Handle Gizmo::handleUnderMouse(const Sight& sight, const SceneBody& body, double height) const {
    const glm::dvec3 foot = height * toGlm(body.position);
    const double far = sight.distance(foot);
    const auto base = sight.at(foot);
    if (!base) return Handle::kNone;
    for (size_t axis = 0; axis < kAxes.size(); ++axis) {
        const auto tip = sight.at(foot + kArrowShare * far * kAxes[axis]);
        if (tip && distanceToLine(sight.mouse, *base, *tip) < kReach)
            return static_cast<Handle>(static_cast<int>(Handle::kX) + static_cast<int>(axis));
    }
    for (int k = 0; k < kRingParts; ++k) {
        const double angle = 2 * 3.14159265 * k / kRingParts;
        const auto at = sight.at(foot + kRingShare * far * glm::dvec3(std::cos(angle), 0, -std::sin(angle)));
        if (at && std::hypot(at->x - sight.mouse.x, at->y - sight.mouse.y) < kReach) return Handle::kTurn;
    }
    return Handle::kNone;
}

/// The foot goes over the picture as the mouse does. What hides it at the beginning makes no jump.
void Gizmo::grabBody(const Shot& shot, const BodyList& bodies, size_t body, const Sight& sight) {
    const glm::dvec3 foot = shot.height * toGlm(shot.bodies[body].position);
    const ImVec2 at = sight.at(foot).value_or(sight.mouse);
    to_foot_ = {at.x - sight.mouse.x, at.y - sight.mouse.y};
    const auto seen = whatRayMeets(shot, bodies, sight.rayThrough(at), body);
    grabbed_ = seen ? seen->point - foot : glm::dvec3(0);
}

/// A handle of the chosen body, else the body under the mouse, which is chosen by it.
void Gizmo::take(PanelContext& context, const BodyList& bodies, const Sight& sight) {
    std::optional<size_t>& chosen = context.state.chosen_body;
    const Shot& shot = context.shot;
    held_ = Handle::kNone;
    if (chosen && *chosen < shot.bodies.size())
        held_ = handleUnderMouse(sight, shot.bodies[*chosen], shot.height);
    if (held_ == Handle::kNone) {
        const auto hit = whatRayMeets(shot, bodies, sight.ray);
        chosen.reset();
        if (!hit || !hit->body || shot.bodies[*hit->body].locked) return;
        chosen = hit->body;
        held_ = Handle::kBody;
        grabBody(shot, bodies, *chosen, sight);
    }
    body_ = *chosen;
    before_ = now_ = shot.bodies[body_];
    moved_ = false;
    const glm::dvec3 foot = shot.height * toGlm(before_.position);
    if (held_ == Handle::kTurn) grabbed_.x = sight.angle(foot).value_or(0);
    if (held_ >= Handle::kX && held_ <= Handle::kZ)
        grabbed_.x = sight.along(foot, kAxes[static_cast<size_t>(held_) - static_cast<size_t>(Handle::kX)]);
}

void Gizmo::drag(const Shot& shot, const BodyList& bodies, const Sight& sight) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > kSlack * kSlack) moved_ = true;
    if (!moved_) return;
    const glm::dvec3 foot = shot.height * toGlm(before_.position);
    glm::dvec3 place = foot;
    if (held_ == Handle::kTurn) {
        if (const auto angle = sight.angle(foot)) now_.yaw = before_.yaw + *angle - grabbed_.x;
    } else if (held_ == Handle::kBody) {
        const ImVec2 at(sight.mouse.x + to_foot_.x, sight.mouse.y + to_foot_.y);
        const auto hit = whatRayMeets(shot, bodies, sight.rayThrough(at), body_);
        if (!hit) return;
        const double x = hit->point.x - grabbed_.x, z = hit->point.z - grabbed_.z;
        place = {x, restingHeight(shot, bodies, body_, x, z, hit->point.y + heightOf(*bodies.at(body_))), z};
    } else {
        const glm::dvec3& axis = kAxes[static_cast<size_t>(held_) - static_cast<size_t>(Handle::kX)];
        place = foot + (sight.along(foot, axis) - grabbed_.x) * axis;
    }
    place = glm::clamp(place, glm::dvec3(kPlaceRange.least), glm::dvec3(kPlaceRange.most));
    now_.position = fromGlm(place / shot.height);
}

void Gizmo::letGo(PanelContext& context) {
    held_ = Handle::kNone;
    if (!moved_ || body_ >= context.shot.bodies.size() || now_ == before_) return;
    context.shot.bodies[body_].position = now_.position;
    context.shot.bodies[body_].yaw = now_.yaw;
    context.changed = true;
}

void Gizmo::draw(const Shot& shot, const BodyList& bodies, size_t body, const Sight& sight) const {
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    list->PushClipRect(sight.corner, ImVec2(sight.corner.x + sight.size.x, sight.corner.y + sight.size.y));
    const auto line = [&](const glm::dvec3& from, const glm::dvec3& to, ImU32 colour, float width) {
        const auto a = sight.at(from), b = sight.at(to);
        if (a && b) list->AddLine(*a, *b, colour, width);
    };
    const auto corners = cornersOf(shot, bodies, body);
    for (size_t k = 0; k < corners.size(); ++k)
        for (const size_t bit : {1u, 2u, 4u})
            if ((k & bit) == 0) line(corners[k], corners[k | bit], IM_COL32(255, 190, 80, 200), 1.2f);
    const glm::dvec3 foot = shot.height * toGlm(shot.bodies[body].position);
    const double far = sight.distance(foot);
    for (int k = 0; k < kRingParts; ++k) {
        const auto on_ring = [&](int part) {
            const double angle = 2 * 3.14159265 * part / kRingParts;
            return foot + kRingShare * far * glm::dvec3(std::cos(angle), 0, -std::sin(angle));
        };
        line(on_ring(k), on_ring(k + 1), IM_COL32(240, 220, 90, 255), held_ == Handle::kTurn ? 4.0f : 2.2f);
    }
    const ImU32 colours[] = {IM_COL32(235, 75, 75, 255), IM_COL32(110, 210, 90, 255),
                             IM_COL32(80, 140, 250, 255)};
    for (size_t axis = 0; axis < kAxes.size(); ++axis) {
        const glm::dvec3 tip = foot + kArrowShare * far * kAxes[axis];
        const bool is_held = static_cast<size_t>(held_) == static_cast<size_t>(Handle::kX) + axis;
        line(foot, tip, colours[axis], is_held ? 4.0f : 2.2f);
        if (const auto at = sight.at(tip)) list->AddCircleFilled(*at, is_held ? 6.0f : 4.5f, colours[axis]);
    }
    list->PopClipRect();
}

bool Gizmo::update(PanelContext& context, const BodyList& bodies, const engine::Camera& camera,
                   const PictureArea& area) {
    const bool fits = bodies.size() == context.shot.bodies.size();
    if (!context.state.arrange || !fits) {
        held_ = Handle::kNone;
        return false;
    }
    const Sight sight(camera, area);
    const ImGuiIO& io = ImGui::GetIO();
    if (held_ == Handle::kNone && io.MouseClicked[ImGuiMouseButton_Left] && !io.KeyAlt && sight.holdsMouse())
        take(context, bodies, sight);
    const bool was_held = held_ != Handle::kNone;
    if (was_held) drag(context.shot, bodies, sight);
    const auto& chosen = context.state.chosen_body;
    if (chosen && *chosen < bodies.size()) {
        Shot shown = context.shot;
        if (was_held && moved_) shown.bodies[body_] = now_;
        draw(shown, bodies, *chosen, sight);
    }
    if (was_held && !io.MouseDown[ImGuiMouseButton_Left]) letGo(context);
    return was_held;
}

}  // namespace demolish
