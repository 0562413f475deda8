// Vertices of the exposed faces, for both sides of each: the same positions, each with its side's smooth
// normal.
#pragma once
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
    Span<const uint32_t> first_vertex;  ///< of each face in the stream
    Span<const uint32_t> fragment;      ///< slot of each particle
    PoolCorners corners;
    Span<const uint8_t> surface_distance;
    Span<const float> spacing;
    Span<const Float3> position;  ///< pool
    Span<SurfaceVertex> out;

    DEM_FN void operator()(uint32_t index) const {
        const uint32_t f = face_of_vertex[index];
        if (face_state[f] == kFaceHidden || first_vertex[f + 1] > out.size()) return;
        const InteriorFace face = faces[f];
        const uint32_t pool = face_vertices[index];
        const uint32_t to = first_vertex[f] + (index - face.first_vertex);
        out[to] = vertexOfSide(pool, face.cell_a);
        out[to + face.vertex_count] = vertexOfSide(pool, face.cell_b);
    }

    /// The normal points out of the cell's fragment: all exposed faces of the fragment that meet here, by
    /// area.
    DEM_FN SurfaceVertex vertexOfSide(uint32_t pool, uint32_t cell) const {
        const uint32_t slot = fragment[cell];
        const Vec3<float> here = toVec3(position[pool]);
        Vec3<float> normal, neighbours;
        float count = 0;
        for (uint32_t c = corners.start[pool]; c < corners.start[pool + 1]; ++c) {
            if (face_state[corners.face[c]] == kFaceHidden) continue;
            const InteriorFace& face = faces[corners.face[c]];
            const bool side_a = fragment[face.cell_a] == slot;
            if (!side_a && fragment[face.cell_b] != slot) continue;
            const Vec3<float> next = toVec3(position[corners.next[c]]) - here;
            const Vec3<float> previous = toVec3(position[corners.previous[c]]) - here;
            const Vec3<float> area = cross(next, previous);
            normal = side_a ? normal + area : normal - area;
            neighbours = neighbours + (next + previous);
            count += 2.0f;
        }
        normal = normalized(normal);
        const float bend = -dot(normal, neighbours) / (count * kFullBend * spacing[pool]);
        const float depth = static_cast<float>(surface_distance[pool]) / static_cast<float>(kInnerDistance);
        return {position[pool], packOctahedral(normal.x, normal.y, normal.z),
                packHalf2(depth, clampTo(bend, -1.0f, 1.0f)), cell};
    }
};

}  // namespace demolish
