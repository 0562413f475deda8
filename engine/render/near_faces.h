// SPDX-License-Identifier: Apache-2.0
// Broken faces near the camera, made finer with the material's relief in them: what is shown in place of the
// mesh's own of some cells (shaders/common/near_faces.glsl).
#pragma once
#include <cstdint>

#include "engine/gl/buffer.h"

namespace demolish::engine {

struct NearFaces {
    /// As the words before the indices: a draw command, then work groups.
    struct Header {
        uint32_t count, instances, first, base_vertex, base_instance, groups[3];
    };
    static constexpr size_t kMostTriangles = size_t{1} << 20, kMostVertices = size_t{3} << 19;

    gl::Buffer cells;      ///< u32 a cell: 1 where the mesh's own broken faces are not shown
    gl::Buffer indices;    ///< Header, then 3 a triangle
    gl::Buffer vertices;   ///< 24 B, as StreamId::kInteriorVertices
    uint64_t version = 0;  ///< changes with what they show; 0: nothing
};
static_assert(sizeof(NearFaces::Header) == 32);

/// Whether any are shown. Reads the buffer where it lies: cheap in software alone.
inline bool showsAny(const NearFaces& near) {
    return gl::BufferReading(near.indices).as<NearFaces::Header>()[0].count > 0;
}

}  // namespace demolish::engine
