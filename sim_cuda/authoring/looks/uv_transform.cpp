// SPDX-License-Identifier: Apache-2.0
// The extension counts v downwards and turns about the origin; assimp counts turns the other way, and its
// translation is one that turns about the middle, so the file's offset is got back first.
#include "sim_cuda/authoring/looks/uv_transform.h"

#include <assimp/material.h>

#include <cmath>
#include <utility>

namespace demolish {

UvTransform uvTransformOfGltf(const aiUVTransform& transform) {
    const double scale_u = double(transform.mScaling.x), scale_v = double(transform.mScaling.y),
                 cosine = std::cos(double(transform.mRotation)),
                 sine = -std::sin(double(transform.mRotation));
    const double offset_u = double(transform.mTranslation.x) - 0.5 * scale_u * (1 - cosine + sine),
                 offset_v =
                     0.5 * scale_v * (cosine + sine - 1) + 1 - scale_v - double(transform.mTranslation.y);
    const double u[] = {cosine * scale_u, -sine * scale_v, offset_u + sine * scale_v},
                 v[] = {sine * scale_u, cosine * scale_v, 1 - offset_v - cosine * scale_v};
    for (const double number : {u[0], u[1], u[2], v[0], v[1], v[2]})
        if (!std::isfinite(number)) return {};
    return {{float(u[0]), float(u[1]), float(u[2])}, {float(v[0]), float(v[1]), float(v[2])}};
}

UvTransform uvTransformOfRepeats(const aiUVTransform& transform) {
    const auto [scale, offset] = std::pair(transform.mScaling, transform.mTranslation);
    for (const auto number : {scale.x, scale.y, offset.x, offset.y})
        if (!std::isfinite(number)) return {};
    if (scale.x == 0 || scale.y == 0) return {};
    return {{float(scale.x), 0, float(offset.x)}, {0, float(scale.y), float(offset.y)}};
}

}  // namespace demolish
