// SPDX-License-Identifier: Apache-2.0
// Vertices of the exposed faces, for both sides of each: the same positions, each with its side's smooth
// normal.
#pragma once
#include "sim_cuda/data/crack_smoothing.h"
#include "sim_cuda/data/fracture_mesh.h"
#include "sim_cuda/kernels/spread_surface_distance.h"
#include "sim_cuda/physics/vertex_packing.h"

namespace demolish {

/// One call per vertex of a face. uv holds what shading of broken material needs: u = distance from the
/// outside, 0 (on it) .. 1; v = -1 (pit) .. 1 (ridge), a bend of kFullBend h.
struct WriteInteriorVertices {
    static constexpr float kFullBend = 0.2f;

    Span<const InteriorFace> faces;
    Span<const uint32_t> face_of_vertex, face_vertices;
    Span<const uint8_t> face_state;
    Span<const uint32_t> first_vertex;   ///< of each face in the stream
    Span<const uint32_t> fragment;       ///< slot of each particle
    Span<const uint32_t> fragment_size;  ///< cells, by slot
    PoolCorners corners;
    Span<const uint8_t> surface_distance;
    Span<const float> spacing;
    Span<const Float3> position;  ///< pool
    Span<SurfaceVertex> out;
    bool smooth = true;  ///< false: every face is flat

    DEM_FN void operator()(uint32_t index) const {
        const uint32_t f = face_of_vertex[index];
        if (face_state[f] == kFaceHidden || first_vertex[f + 1] > out.size()) return;
        const InteriorFace face = faces[f];
        const uint32_t pool = face_vertices[index];
        Side a = sideOf(face.cell_a, f), b = sideOf(face.cell_b, f);
        gather(pool, a, b);
        const uint32_t to = first_vertex[f] + (index - face.first_vertex);
        out[to] = vertexOfSide(pool, face.cell_a, a);
        out[to + face.vertex_count] = vertexOfSide(pool, face.cell_b, b);
    }

  private:
    static constexpr uint32_t kEveryFace = 0xffffffffu;

    /// Of the fragment on one side of a face: all its exposed faces that meet at a vertex, or this one alone.
    struct Side {
        uint32_t slot, only;
        Vec3<float> normal{}, neighbours{};
        float count = 0;

        DEM_FN void add(bool outward, const Vec3<float>& area, const Vec3<float>& next_and_previous) {
            normal = outward ? normal + area : normal - area;
            neighbours = neighbours + next_and_previous;
            count += 2.0f;
        }
    };
    /// Faces of pieces of a few cells are flat, and their edges sharp.
    DEM_FN Side sideOf(uint32_t cell, uint32_t face) const {
        const uint32_t slot = fragment[cell];
        return {slot, !smooth || fragment_size[slot] <= kMostCellsPlaned ? face : kEveryFace};
    }
    /// Both at once: what is read for one side is read for the other.
    DEM_FN void gather(uint32_t pool, Side& a, Side& b) const {
        const Vec3<float> here = toVec3(position[pool]);
        for (uint32_t c = corners.start[pool]; c < corners.start[pool + 1]; ++c) {
            const uint32_t f = corners.face[c];
            if (face_state[f] == kFaceHidden) continue;
            const uint32_t slot_a = fragment[faces[f].cell_a], slot_b = fragment[faces[f].cell_b];
            const bool of_a = (slot_a == a.slot || slot_b == a.slot) && (a.only == kEveryFace || a.only == f);
            const bool of_b = (slot_a == b.slot || slot_b == b.slot) && (b.only == kEveryFace || b.only == f);
            if (!of_a && !of_b) continue;
            const Vec3<float> next = toVec3(position[corners.next[c]]) - here;
            const Vec3<float> previous = toVec3(position[corners.previous[c]]) - here;
            const Vec3<float> area = cross(next, previous);
            if (of_a) a.add(slot_a == a.slot, area, next + previous);
            if (of_b) b.add(slot_a == b.slot, area, next + previous);
        }
    }
    /// The normal points out of the cell's fragment, by area.
    DEM_FN SurfaceVertex vertexOfSide(uint32_t pool, uint32_t cell, const Side& side) const {
        const Vec3<float> normal = normalized(side.normal);
        const float bend = -dot(normal, side.neighbours) / (side.count * kFullBend * spacing[pool]);
        const float depth = static_cast<float>(surface_distance[pool]) / static_cast<float>(kInnerDistance);
        return {position[pool], packOctahedral(normal.x, normal.y, normal.z),
                packHalf2(depth, clampTo(bend, -1.0f, 1.0f)), cell};
    }
};

}  // namespace demolish
