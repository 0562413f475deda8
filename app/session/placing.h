// SPDX-License-Identifier: Apache-2.0
// Whole bodies at their places, taken hold of by rays: which one a ray meets, and where one comes to stand.
#pragma once
#include <optional>

#include "app/session/shot_setup.h"
#include "engine/scene/camera.h"

namespace demolish {

struct RayHit {
    std::optional<size_t> body;  ///< none: the floor or a collider
    glm::dvec3 point{0};         ///< m
};

/// What the ray meets first of bodies (as their particles are) but `without`, colliders and the floor; none
/// where it goes past all of them.
std::optional<RayHit> whatRayMeets(const Shot& shot, const BodyList& bodies, const engine::Ray& ray,
                                   std::optional<size_t> without = std::nullopt);

/// m, y at which the body's foot stands at x, z on what lies below it: other bodies below its outline,
/// colliders below its middle, the floor. Nothing above `from` (m) counts.
double restingHeight(const Shot& shot, const BodyList& bodies, size_t body, double x, double z, double from);

/// Corners of the box round a body as the shot places it, m; corner k has the high x, y, z for bits 0, 1, 2.
std::array<glm::dvec3, 8> cornersOf(const Shot& shot, const BodyList& bodies, size_t body);

}  // namespace demolish
