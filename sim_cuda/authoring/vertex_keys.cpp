// SPDX-License-Identifier: Apache-2.0
// Keys in sorted order and the positions that follow from them.
#include "sim_cuda/authoring/vertex_keys.h"

#include <algorithm>
#include <utility>

namespace demolish {

namespace {

Double3 onEdge(const KeySpace& space, uint32_t edge, double parameter) {
    const Double3 &a = space.mesh.positions[space.edges.ends[edge][0]],
                  &b = space.mesh.positions[space.edges.ends[edge][1]];
    return a + (b - a) * parameter;
}

Double3 onTriangle(const KeySpace& space, uint32_t triangle, const Double3& barycentrics) {
    const auto& t = space.mesh.triangles[triangle];
    const Double3& a = space.mesh.positions[t[0]];
    return a + (space.mesh.positions[t[1]] - a) * barycentrics.y +
           (space.mesh.positions[t[2]] - a) * barycentrics.z;
}

/// Relative to the lowest seed, where the numbers are small.
Double3 circumcentre(const Double3& i, const Double3& j, const Double3& k, const Double3& l) {
    const Double3 p = j - i, q = k - i, r = l - i;
    const Double3 qr = cross(q, r), rp = cross(r, p), pq = cross(p, q);
    const double scale = 0.5 / dot(p, qr);
    return i + (qr * lengthSquared(p) + rp * lengthSquared(q) + pq * lengthSquared(r)) * scale;
}

}  // namespace

VertexKey meshKey(uint32_t vertex) {
    return {VertexKind::kMesh, {vertex, 0, 0, 0}};
}
VertexKey edgeKey(uint32_t edge, uint32_t i, uint32_t j) {
    return {VertexKind::kMeshEdge, {edge, std::min(i, j), std::max(i, j), 0}};
}
VertexKey triangleKey(uint32_t triangle, uint32_t i, uint32_t j, uint32_t k) {
    if (i > j) std::swap(i, j);
    if (j > k) std::swap(j, k);
    if (i > j) std::swap(i, j);
    return {VertexKind::kTriangle, {triangle, i, j, k}};
}
VertexKey interiorKey(uint32_t i, uint32_t j, uint32_t k, uint32_t l) {
    if (i > j) std::swap(i, j);
    if (k > l) std::swap(k, l);
    if (i > k) std::swap(i, k);
    if (j > l) std::swap(j, l);
    if (j > k) std::swap(j, k);
    return {VertexKind::kInterior, {i, j, k, l}};
}

double edgeParameter(const KeySpace& space, uint32_t edge, uint32_t i, uint32_t j) {
    const auto& ends = space.edges.ends[edge];
    const double low = nearerTo(space.seeds[j], space.seeds[i], space.mesh.positions[ends[0]]);
    const double high = nearerTo(space.seeds[j], space.seeds[i], space.mesh.positions[ends[1]]);
    return low / (low - high);
}

Double3 triangleBarycentrics(const KeySpace& space, uint32_t triangle, uint32_t i, uint32_t j, uint32_t k) {
    const auto& t = space.mesh.triangles[triangle];
    const Double3 &a = space.mesh.positions[t[0]], ab = space.mesh.positions[t[1]] - a,
                  ac = space.mesh.positions[t[2]] - a;
    const Double3 to_j = space.seeds[j] - space.seeds[i], to_k = space.seeds[k] - space.seeds[i];
    const double rest_j = nearerTo(space.seeds[j], space.seeds[i], a),
                 rest_k = nearerTo(space.seeds[k], space.seeds[i], a);
    const double jb = 2 * dot(to_j, ab), jc = 2 * dot(to_j, ac);
    const double kb = 2 * dot(to_k, ab), kc = 2 * dot(to_k, ac);
    const double scale = 1 / (jb * kc - jc * kb);
    const double u = (jc * rest_k - rest_j * kc) * scale, v = (rest_j * kb - jb * rest_k) * scale;
    return {1 - u - v, u, v};
}

Double3 positionOf(const KeySpace& space, const VertexKey& key) {
    const auto& [a, b, c, d] = key.ids;
    switch (key.kind) {
        case VertexKind::kMesh:
            return space.mesh.positions[a];
        case VertexKind::kMeshEdge:
            return onEdge(space, a, edgeParameter(space, a, b, c));
        case VertexKind::kTriangle:
            return onTriangle(space, a, triangleBarycentrics(space, a, b, c, d));
        case VertexKind::kInterior:
            break;
    }
    return circumcentre(space.seeds[a], space.seeds[b], space.seeds[c], space.seeds[d]);
}

}  // namespace demolish
