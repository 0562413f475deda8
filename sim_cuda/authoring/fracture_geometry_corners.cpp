// SPDX-License-Identifier: Apache-2.0
// Which triangle corners meet at each pool vertex: the lists that relaxation and smooth normals gather from.
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "sim_cuda/authoring/fracture_geometry_parts.h"

namespace demolish {
namespace {

using FaceRange = tbb::blocked_range<size_t>;

template <class Visit>
void forEachCorner(const FractureGeometry& geometry, const FaceRange& faces, Visit&& visit) {
    for (size_t f = faces.begin(); f < faces.end(); ++f) {
        const InteriorFace& face = geometry.faces[f];
        for (uint32_t index = face.first_index; index < face.first_index + face.index_count; ++index)
            visit(index, geometry.face_vertices[face.first_vertex + geometry.face_indices[index]]);
    }
}

/// Index of the next or previous corner of the same triangle.
uint32_t turned(uint32_t index, uint32_t steps) {
    const uint32_t triangle = index / 3 * 3;
    return triangle + (index - triangle + steps) % 3;
}

/// Corner indices by pool vertex. Threads claim places in any order; sorting each short row makes it one
/// order.
std::vector<uint32_t> cornersByVertex(FractureGeometry& geometry) {
    std::vector<uint32_t>& start = geometry.pool_corner_start;
    start.assign(geometry.pool.size() + 1, 0);
    const FaceRange all(0, geometry.faces.size(), 256);
    tbb::parallel_for(all, [&](const FaceRange& faces) {
        forEachCorner(geometry, faces, [&](uint32_t, uint32_t vertex) {
            std::atomic_ref(start[vertex + 1]).fetch_add(1, std::memory_order_relaxed);
        });
    });
    for (size_t v = 0; v < geometry.pool.size(); ++v) start[v + 1] += start[v];
    std::vector<uint32_t> cursor(start.begin(), start.end() - 1);
    std::vector<uint32_t> corners(start.back());
    tbb::parallel_for(all, [&](const FaceRange& faces) {
        forEachCorner(geometry, faces, [&](uint32_t index, uint32_t vertex) {
            corners[std::atomic_ref(cursor[vertex]).fetch_add(1, std::memory_order_relaxed)] = index;
        });
    });
    tbb::parallel_for(tbb::blocked_range<size_t>(0, geometry.pool.size(), 1024), [&](const auto& vertices) {
        for (size_t v = vertices.begin(); v < vertices.end(); ++v)
            std::sort(corners.begin() + start[v], corners.begin() + start[v + 1]);
    });
    return corners;
}

}  // namespace

void listPoolCorners(FractureGeometry& geometry) {
    const std::vector<uint32_t> corners = cornersByVertex(geometry);
    std::vector<uint32_t> face_of_triangle(geometry.face_indices.size() / 3);
    std::vector<uint32_t> vertex_of_corner(geometry.face_indices.size());
    tbb::parallel_for(FaceRange(0, geometry.faces.size(), 256), [&](const FaceRange& faces) {
        for (size_t f = faces.begin(); f < faces.end(); ++f)
            forEachCorner(geometry, FaceRange(f, f + 1), [&](uint32_t index, uint32_t vertex) {
                face_of_triangle[index / 3] = static_cast<uint32_t>(f);
                vertex_of_corner[index] = vertex;
            });
    });
    geometry.pool_corner_face.resize(corners.size());
    geometry.pool_corner_next.resize(corners.size());
    geometry.pool_corner_previous.resize(corners.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, corners.size(), 4096), [&](const auto& range) {
        for (size_t c = range.begin(); c < range.end(); ++c) {
            geometry.pool_corner_face[c] = face_of_triangle[corners[c] / 3];
            geometry.pool_corner_next[c] = vertex_of_corner[turned(corners[c], 1)];
            geometry.pool_corner_previous[c] = vertex_of_corner[turned(corners[c], 2)];
        }
    });
}

}  // namespace demolish
