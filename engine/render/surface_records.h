// SPDX-License-Identifier: Apache-2.0
// What a rasteriser hands to the shader of a body's surface (shaders/surface.frag), for each triangle that a
// pixel shows: interpolated in the middle of the pixel, from the corners.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/render/frame_uniforms.h"
#include "engine/render/mesh_motion.h"
#include "engine/render/small_raster.h"

namespace demolish::engine {

inline constexpr uint32_t kInteriorBit = 0x80000000u;  ///< of names: a broken face

/// A sample of the picture. Depths, reversed, stand above names: the greater is nearer, or drawn later.
struct NamedSample {
    uint32_t name;   ///< from 1 on, with kInteriorBit; 0: nothing
    uint32_t depth;  ///< a float's bits
};
static_assert(sizeof(NamedSample) == 8);

/// Four texels of shaders/surface_record.frag.
struct SurfaceRecord {
    glm::vec3 rest;        ///< m
    uint32_t normal;       ///< in the world, octahedral
    uint32_t rotation[2];  ///< unit quaternion, four snorm16
    uint32_t relief;       ///< two halves, as vertices have them
    uint32_t pixel;        ///< x, and y in the high half
    glm::vec3 right;       ///< change of `rest` to the pixel's right
    float deeper_right;
    glm::vec3 up;
    float deeper_up;
};
static_assert(sizeof(SurfaceRecord) == 64);

/// Triangles of one of a mesh's lists.
struct TriangleSource {
    std::span<const MeshVertex> vertices;
    std::span<const uint32_t> indices;
};

class SurfaceRecords {
  public:
    static constexpr size_t kAcross = 512;  ///< records in a row of the texture
    enum Part { kOutside, kInside, kParts };
    /// Of the texture.
    struct Rows {
        size_t first = 0, count = 0;
    };

    /// Of the samples in `box`; `named`: of a picture `width` wide, `samples` for each pixel. Names of
    /// triangles become those of records: their place, from 1 on.
    void make(std::span<NamedSample> named, int width, int samples, const PixelBox& box,
              const std::array<TriangleSource, kParts>& sources, const MeshMotion& motion,
              const FrameUniforms& frame);
    /// In whole rows: first those of the outside, then those of broken faces.
    std::span<const SurfaceRecord> all() const { return records_; }
    const Rows& rowsOf(Part part) const { return rows_[part]; }

  private:
    void makeRoom();
    std::vector<SurfaceRecord> records_;
    std::array<Rows, kParts> rows_;
    std::vector<std::array<uint32_t, kParts>> first_;  ///< of each row of pixels
};

}  // namespace demolish::engine
