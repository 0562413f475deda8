// SPDX-License-Identifier: Apache-2.0
// The outside's vertices where their points are now, with the normal that the model has there and the
// triangle that its looks are of.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/kernels/surface_walk.h"
#include "sim_cuda/physics/vertex_packing.h"
#include "sim_cuda/physics/vertex_unpacking.h"

namespace demolish {

/// Chunks of vertices of which one has moved. One thread a vertex.
struct MarkChangedChunks {
    Span<const ExteriorHome> home;
    Span<const uint8_t> changed;  ///< points
    Span<uint32_t> chunk;         ///< 0 before

    DEM_FN void operator()(uint32_t v) const {
        if (changed[home[v].point] == 0) return;
        uint32_t* flag = &chunk[v / kExteriorChunk];
        if (atomicLoadU32(flag) == 0) atomicOrU32(flag, 1);
    }
};

/// One thread a vertex.
struct WriteExteriorVertices {
    Span<const SurfaceVertex> rest;
    Span<const ExteriorHome> home;
    OutsideMesh mesh;
    Span<const Float3> position;  ///< points
    Span<const uint32_t> chunk;
    Span<SurfaceVertex> out;

    DEM_FN void operator()(uint32_t v) const {
        if (chunk[v / kExteriorChunk] == 0 || v >= out.size()) return;
        const Float3 now = position[home[v].point];
        out[v] = now == rest[v].position ? rest[v] : movedVertex(v, now);
    }

  private:
    DEM_FN SurfaceVertex movedVertex(uint32_t v, const Float3& now) const {
        SurfaceVertex vertex = rest[v];
        vertex.position = now;
        const SurfaceWalk walk{mesh.triangles};
        MeshPlace place = walk.find(home[v].triangle, toVec3(now), true);
        vertex.place = place.triangle;
        SurfaceWalk::clampInside(place);
        vertex.normal = normalAt(place);
        return vertex;
    }
    DEM_FN uint32_t normalAt(const MeshPlace& place) const {
        Vec3<float> sum;
        for (uint32_t k = 0; k < 3; ++k)
            sum = axpy(place.weight[k], unpackOctahedral(mesh.triangles[place.triangle].normal[k]), sum);
        return packOctahedral(sum.x, sum.y, sum.z);
    }
};

}  // namespace demolish
