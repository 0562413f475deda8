// SPDX-License-Identifier: Apache-2.0
// Pieces of a few cells get a few flat faces: smoothing would leave them the row of balls that a union of
// cells is. Each piece has planes that cut a little off it in some directions of its own, and the vertices of
// its fresh faces go to where these planes let them be.
//
//   middles of all small pieces -> how far each reaches along its directions -> vertices to their planes
//
// Middles are added up in whole numbers and reaches are maxima, so that the order does not matter.
#pragma once
#include <bit>

#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/data/crack_smoothing.h"
#include "sim_cuda/data/fracture_mesh.h"
#include "sim_cuda/kernels/spread_surface_distance.h"
#include "sim_cuda/physics/value_noise.h"

namespace demolish {

/// Planes of a piece.
inline constexpr uint32_t kPiecePlanes = 12;

/// h that they cut off; of the smallest pieces less, so that this share of how far they reach is left.
inline constexpr float kCutOff = 0.4f, kLeastKept = 0.72f;
/// h: how far vertices go at most.
inline constexpr float kOutwards = 0.4f, kInwards = 0.6f;

/// Unit, of plane `k` of the piece with this slot: one of the twelve of a dodecahedron, turned aside.
DEM_FN Vec3<float> pieceDirection(uint32_t slot, uint32_t k) {
    constexpr float kShort = 0.5257311f, kLong = 0.8506508f, kAside = 0.45f;
    const float a = (k & 1u) != 0 ? kShort : -kShort, b = (k & 2u) != 0 ? kLong : -kLong;
    const uint32_t axis = k >> 2;
    const Vec3<float> even = axis == 0   ? Vec3<float>{0, a, b}
                             : axis == 1 ? Vec3<float>{a, b, 0}
                                         : Vec3<float>{b, 0, a};
    const Vec3<float> turned =
        axpy(kAside, latticeVector(static_cast<int32_t>(slot), static_cast<int32_t>(k), 0, 29), even);
    return inverseSqrt(length2(turned)) * turned;
}

/// Of all pieces, by slot.
struct PieceShapes {
    Span<const uint32_t> fragment, fragment_size;  ///< slot of each cell; cells, by slot
    Span<uint64_t> sums;                           ///< three a slot: of its cells' middles, in units
    Span<uint32_t> reach;  ///< kPiecePlanes a slot: m from its middle, bits of a float that is not negative
    float unit = 0;        ///< m

    DEM_FN bool isPlaned(uint32_t slot) const { return demolish::isPlaned(fragment_size[slot]); }
    DEM_FN Vec3<float> middle(uint32_t slot) const {
        const float scale = unit / static_cast<float>(fragment_size[slot]);
        const auto mean = [&](uint32_t k) {
            return scale * static_cast<float>(static_cast<int64_t>(sums[3 * size_t{slot} + k]));
        };
        return {mean(0), mean(1), mean(2)};
    }
    DEM_FN float reachOf(uint32_t slot, uint32_t k) const {
        return std::bit_cast<float>(reach[size_t{kPiecePlanes} * slot + k]);
    }
};

/// Of one cell.
struct AddCellMiddles {
    PieceShapes pieces;
    Span<const Float3> middle;  ///< m, of each cell

    DEM_FN void operator()(uint32_t cell) const {
        const uint32_t slot = pieces.fragment[cell];
        if (!pieces.isPlaned(slot)) return;
        const float value[3] = {middle[cell].x, middle[cell].y, middle[cell].z};
        for (uint32_t k = 0; k < 3; ++k)
            atomicAddU64(&pieces.sums[3 * size_t{slot} + k],
                         static_cast<uint64_t>(static_cast<int64_t>(value[k] / pieces.unit)));
    }
};

/// Of one face.
struct SpreadReach {
    PieceShapes pieces;
    Span<const InteriorFace> faces;
    Span<const uint32_t> face_vertices;
    Span<const uint8_t> face_state;
    Span<const Float3> rest;

    DEM_FN void operator()(uint32_t f) const {
        if (face_state[f] != kFaceNew) return;
        of(faces[f], pieces.fragment[faces[f].cell_a]);
        of(faces[f], pieces.fragment[faces[f].cell_b]);
    }

  private:
    DEM_FN void of(const InteriorFace& face, uint32_t slot) const {
        if (!pieces.isPlaned(slot)) return;
        const Vec3<float> middle = pieces.middle(slot);
        for (uint32_t k = 0; k < kPiecePlanes; ++k) {
            const Vec3<float> direction = pieceDirection(slot, k);
            float farthest = 0;
            for (uint32_t v = 0; v < face.vertex_count; ++v)
                farthest = maxOf(farthest,
                                 dot(direction, toVec3(rest[face_vertices[face.first_vertex + v]]) - middle));
            atomicMaxU32(&pieces.reach[size_t{kPiecePlanes} * slot + k], std::bit_cast<uint32_t>(farthest));
        }
    }
};

/// Of one movable vertex, after smoothing.
struct PlanePoolVertices {
    PieceShapes pieces;
    Span<const uint32_t> smallest_there;  ///< slot of the smallest piece at a movable vertex
    Span<const uint8_t> surface_distance;
    Span<const Float3> rest;
    Span<const float> spacing;
    Span<Float3> position, before;

    DEM_FN void operator()(uint32_t v) const {
        const uint32_t slot = smallest_there[v];
        if (slot == kNoPiece || !pieces.isPlaned(slot)) return;
        const Vec3<float> from = toVec3(rest[v]), here = toVec3(position[v]);
        const Vec3<float> way = here - pieces.middle(slot);
        const float h = spacing[v];
        const float inside = static_cast<float>(surface_distance[v]) / static_cast<float>(kInnerDistance);
        const float share = shareWithin(slot, way, h);
        const float limit = (share > 1.0f ? kOutwards : kInwards) * h;
        const Vec3<float> moved = axpy(inside * (share - 1.0f), way, here - from);
        const float squared = length2(moved);
        const float scale = squared > limit * limit ? limit * inverseSqrt(squared) : 1.0f;
        position[v] = before[v] = toFloat3(axpy(scale, moved, from));
    }

  private:
    /// Of the way from the piece's middle, up to its planes.
    DEM_FN float shareWithin(uint32_t slot, const Vec3<float>& way, float h) const {
        float share = 2.0f;
        for (uint32_t k = 0; k < kPiecePlanes; ++k) {
            const float along = dot(pieceDirection(slot, k), way), reach = pieces.reachOf(slot, k);
            const float plane = maxOf(reach - kCutOff * h, kLeastKept * reach);
            if (along * share > plane) share = plane / along;
        }
        return share;
    }
};

}  // namespace demolish
