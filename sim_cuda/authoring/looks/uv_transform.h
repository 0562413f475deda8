// SPDX-License-Identifier: Apache-2.0
// How a picture is laid over the UVs of a model: repeated, moved and turned, as by glTF's
// KHR_texture_transform.
#pragma once
#include "sim_cuda/api/triangle_mesh.h"

struct aiUVTransform;

namespace demolish {

/// u' = u_row . (u, v, 1), v' = v_row . (u, v, 1); v grows upwards.
struct UvTransform {
    Float3 u_row{1, 0, 0}, v_row{0, 1, 0};
    bool operator==(const UvTransform&) const = default;
    Float2 operator()(const Float2& uv) const {
        return {u_row.x * uv.x + u_row.y * uv.y + u_row.z, v_row.x * uv.x + v_row.y * uv.y + v_row.z};
    }
};

/// Of what assimp makes of the extension. None where its numbers are not finite.
UvTransform uvTransformOfGltf(const aiUVTransform& transform);

/// Of what it makes of repeats and offsets in DAE and FBX files: u' = s u + o. None where its numbers are not
/// finite, or nothing would be left of the picture; turns are left out.
UvTransform uvTransformOfRepeats(const aiUVTransform& transform);

}  // namespace demolish
