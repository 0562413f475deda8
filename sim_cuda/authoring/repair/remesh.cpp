// SPDX-License-Identifier: Apache-2.0
// Field, contour, looks.
#include "sim_cuda/authoring/repair/remesh.h"

#include <tbb/parallel_for.h>

#include <algorithm>

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

/// Farther than this from the original (m) is over a hole: no looks to take.
void takeLooks(RepairMesh& surface, const RepairMesh& original, const MeshQueries& queries, double reach) {
    tbb::parallel_for(size_t(0), surface.size(), [&](size_t t) {
        const ClosestPoint nearest = queries.closestPoint(surface.middle(t));
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
