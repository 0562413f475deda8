// SPDX-License-Identifier: Apache-2.0
// Symbolic vertices: keys, the positions that follow from them alone, and ids by key (geometry.md 2.1).
#pragma once
#include <vector>

#include "sim_cuda/authoring/cell_complex.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/mesh_edges.h"

namespace demolish {

/// > 0: `p` is nearer to `j` than to `i` (m^2). Swapping i and j negates it exactly.
inline double nearerTo(const Double3& j, const Double3& i, const Double3& p) {
    return (j.x - i.x) * ((p.x - i.x) + (p.x - j.x)) + (j.y - i.y) * ((p.y - i.y) + (p.y - j.y)) +
           (j.z - i.z) * ((p.z - i.z) + (p.z - j.z));
}

/// What keys refer to.
struct KeySpace {
    const TriangleMesh& mesh;
    const MeshEdges& edges;
    const std::vector<Double3>& seeds;
};

VertexKey meshKey(uint32_t vertex);
VertexKey edgeKey(uint32_t edge, uint32_t i, uint32_t j);
VertexKey triangleKey(uint32_t triangle, uint32_t i, uint32_t j, uint32_t k);
VertexKey interiorKey(uint32_t i, uint32_t j, uint32_t k, uint32_t l);

/// B: share (0 to 1) of the edge's higher vertex, with i < j.
double edgeParameter(const KeySpace& space, uint32_t edge, uint32_t i, uint32_t j);
/// C: barycentrics in the triangle, with i < j < k.
Double3 triangleBarycentrics(const KeySpace& space, uint32_t triangle, uint32_t i, uint32_t j, uint32_t k);

Double3 positionOf(const KeySpace& space, const VertexKey& key);

struct NumberedVertices {
    std::vector<ComplexVertex> vertices;  ///< unique, sorted by key
    std::vector<uint32_t> ids;            ///< by entry of the list of keys
};

/// Unique vertices of a list of keys.
NumberedVertices numberVertices(const KeySpace& space, const std::vector<VertexKey>& keys);

}  // namespace demolish
