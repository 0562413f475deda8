// SPDX-License-Identifier: Apache-2.0
// Field, contour, looks.
#include "sim_cuda/authoring/repair/remesh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "sim_cuda/authoring/corner_looks.h"
#include "sim_cuda/authoring/repair/doubles.h"
#include "sim_cuda/authoring/repair/dual_contouring.h"
#include "sim_cuda/authoring/repair/inside_field.h"
#include "sim_cuda/authoring/repair/orientation.h"
#include "sim_cuda/authoring/unused_vertices.h"

namespace demolish {
namespace {

constexpr double kLeastAgreement = 0.3;  // cosine between a taken normal and the face's own

Float3 toFloat(const Double3& v) {
    return {float(v.x), float(v.y), float(v.z)};
}

/// Of a point of the triangle's plane; a third each where it has no area.
std::array<double, 3> barycentrics(const RepairMesh& mesh, uint32_t triangle, const Double3& p) {
    const Double3 &a = mesh.at(triangle, 0), &b = mesh.at(triangle, 1), &c = mesh.at(triangle, 2);
    const Double3 normal = cross(b - a, c - a);
    const double whole = lengthSquared(normal);
    if (!(whole > 0)) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
    const double u = dot(normal, cross(c - b, p - b)) / whole, v = dot(normal, cross(a - c, p - c)) / whole;
    return {u, v, 1 - u - v};
}

/// Barycentrics held within the triangle.
std::array<double, 3> within(std::array<double, 3> weights) {
    double sum = 0;
    for (double& weight : weights) sum += weight = std::clamp(weight, 0.0, 1.0);
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// The original's normal within the triangle, or the face's own where they disagree.
Float3 normalAt(const Corners& corners, const std::array<double, 3>& weights, const Double3& of_face) {
    const std::array<double, 3> held = within(weights);
    Double3 mean;
    for (size_t k = 0; k < 3; ++k) {
        const Float3& n = corners[k].normal;
        mean += Double3{n.x, n.y, n.z} * held[k];
    }
    mean = normalized(mean);
    return toFloat(dot(mean, of_face) < kLeastAgreement ? of_face : mean);
}

/// By triangle. Triangles that follow each other mostly lie close together: where the one before lies bounds
/// the search.
std::vector<ClosestPoint> closestToMiddles(const RepairMesh& surface, const MeshQueries& queries) {
    constexpr size_t kBlock = 64;
    constexpr double kRounding = 1 + 1e-9;
    std::vector<ClosestPoint> all(surface.size());
    tbb::parallel_for(size_t(0), (all.size() + kBlock - 1) / kBlock, [&](size_t block) {
        const size_t begin = block * kBlock, end = std::min(begin + kBlock, all.size());
        for (size_t t = begin; t < end; ++t) {
            const Double3 middle = surface.middle(t);
            const double bound = t > begin ? length(middle - all[t - 1].point) * kRounding
                                           : std::numeric_limits<double>::infinity();
            all[t] = queries.closestPoint(middle, bound);
            // Within rounding of the surface, or the numbers leave the bound no room.
            if (all[t].triangle == kNoTriangle) all[t] = queries.closestPoint(middle);
        }
    });
    return all;
}

/// Farther than this from the original (m) is over a hole: no looks to take.
void takeLooks(RepairMesh& surface, const RepairMesh& original, const MeshQueries& queries, double reach) {
    const std::vector<ClosestPoint> all = closestToMiddles(surface, queries);
    tbb::parallel_for(size_t(0), surface.size(), [&](size_t t) {
        const ClosestPoint& nearest = all[t];
        const Corners& from = original.mesh.corners[nearest.triangle];
        const Double3 of_face = surface.normal(t);
        surface.source[t] = original.source[nearest.triangle];
        for (size_t k = 0; k < 3; ++k) {
            const auto weights = barycentrics(original, nearest.triangle, surface.at(t, int(k)));
            CornerAttributes& corner = surface.mesh.corners[t][k];
            corner.uv = corner.second_uv = {};
            corner.colour = blendColours({from[0].colour, from[1].colour, from[2].colour}, within(weights));
            corner.material = from[0].material;
            for (size_t i = 0; i < 3; ++i) {
                corner.uv.x += float(weights[i] * from[i].uv.x);
                corner.uv.y += float(weights[i] * from[i].uv.y);
                corner.second_uv.x += float(weights[i] * from[i].second_uv.x);
                corner.second_uv.y += float(weights[i] * from[i].second_uv.y);
            }
            corner.normal = nearest.distance > reach ? toFloat(of_face) : normalAt(from, weights, of_face);
        }
    });
}

}  // namespace

RepairMesh remeshed(const RepairMesh& original, bool is_closed, int cells) {
    const MeshQueries queries(original.mesh);
    const NodeFrame frame = frameAbout(original.mesh, cells);
    const auto field = insideField(original.mesh, queries, frame, is_closed);
    TriangleMesh contour = dualContour(field, frame, original.mesh, queries);
    contour.corners.resize(contour.triangles.size());
    RepairMesh surface(std::move(contour));
    if (surface.size() == 0) return surface;
    takeLooks(surface, original, queries, frame.step);
    settleDoubles(surface);
    dropUnusedVertices(surface.mesh);
    numberParts(surface);
    return surface;
}

}  // namespace demolish
