// SPDX-License-Identifier: Apache-2.0
// Points of the outside, numbered once for all who stand on them: how each may slide, and what lies round it.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "sim_cuda/authoring/corner_looks.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/fracture_geometry_parts.h"
#include "sim_cuda/authoring/symmetric_axes.h"
#include "sim_cuda/physics/vertex_packing.h"

namespace demolish {
namespace {

constexpr uint32_t kNoPoint = 0xffffffffu;
/// Of the mean of n n^T round a point: two triangles that meet at an angle t have the second eigenvalue
/// sin^2(t / 2); 0.05 is 26 degrees.
constexpr double kSharp = 0.05;

Float3 toFloat(const Double3& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// What the pieces of the outside round a point add up to.
struct Surroundings {
    SymmetricTensor squares;
    Double3 normal;
    double count = 0;

    void add(const Double3& n) {
        squares.xx += n.x * n.x;
        squares.yy += n.y * n.y;
        squares.zz += n.z * n.z;
        squares.xy += n.x * n.y;
        squares.yz += n.y * n.z;
        squares.zx += n.z * n.x;
        normal += n;
        ++count;
    }
};

void setSlide(const Surroundings& round, OutsidePoint& point) {
    point.normal = toFloat(normalized(round.normal));
    const SymmetricAxes axes = symmetricAxes(round.squares);
    const double sharp = kSharp * round.count;
    point.kind = axes.value[2] > sharp   ? SlideKind::kNone
                 : axes.value[1] > sharp ? SlideKind::kEdge
                                         : SlideKind::kPlane;
    point.axis = toFloat(axes.axis[point.kind == SlideKind::kEdge ? 2 : 0]);
}

std::vector<Double3> triangleNormals(const TriangleMesh& mesh) {
    std::vector<Double3> normals;
    normals.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
        normals.push_back(
            normalized(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])));
    return normals;
}

/// Numbers points in the order in which cells meet them, so that neighbours lie together in memory.
void numberPoints(const TriangleMesh& mesh, const CellComplex& complex,
                  const std::vector<uint32_t>& corner_vertex, const std::vector<uint32_t>& pool_of_vertex,
                  FractureGeometry& geometry) {
    const std::vector<Double3> normals = triangleNormals(mesh);
    std::vector<uint32_t> point_of_vertex(complex.vertices.size(), kNoPoint);
    std::vector<Surroundings> round;
    geometry.exterior_home.assign(geometry.exterior.size(), {kNoPoint, 0});
    for (const ExteriorPiece& piece : complex.pieces)
        for (uint32_t at = piece.first; at < piece.first + piece.count; ++at) {
            const uint32_t v = complex.exterior_loop[at];
            if (point_of_vertex[v] == kNoPoint) {
                point_of_vertex[v] = static_cast<uint32_t>(geometry.points.size());
                geometry.points.push_back({.position = toFloat(complex.vertices[v].position),
                                           .triangle = piece.triangle,
                                           .normal = {},
                                           .spacing = 0,
                                           .axis = {},
                                           .reach = 0,
                                           .kind = SlideKind::kNone,
                                           .cell = piece.cell,
                                           .pool = pool_of_vertex[v]});
                round.emplace_back();
            }
            round[point_of_vertex[v]].add(normals[piece.triangle]);
            ExteriorHome& home = geometry.exterior_home[corner_vertex[at]];
            if (home.point == kNoPoint) home = {point_of_vertex[v], piece.triangle};
        }
    tbb::parallel_for(size_t(0), round.size(), [&](size_t p) { setSlide(round[p], geometry.points[p]); });
}

void listTriangles(const TriangleMesh& mesh, FractureGeometry& geometry) {
    struct Side {
        uint64_t key;
        uint32_t triangle;
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    const auto keyOf = [](uint32_t u, uint32_t v) { return uint64_t{u} << 32 | v; };
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k)
            sides.push_back({keyOf(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]), t});
    const auto less = [](const Side& a, const Side& b) {
        return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
    };
    std::sort(sides.begin(), sides.end(), less);
    geometry.mesh_triangles.resize(mesh.triangles.size());
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
            MeshTriangle& triangle = geometry.mesh_triangles[t];
            const CornerAttributes& corner = mesh.corners[t][k];
            triangle.corner[k] = toFloat(mesh.positions[mesh.triangles[t][k]]);
            triangle.normal[k] = packOctahedral(corner.normal.x, corner.normal.y, corner.normal.z);
            triangle.chart[k] = chartOf(corner);
            const Side wanted{keyOf(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][k]), 0};
            const auto beyond = std::lower_bound(sides.begin(), sides.end(), wanted, less);
            const bool found = beyond != sides.end() && beyond->key == wanted.key;
            triangle.neighbour[k] = found ? beyond->triangle : kNoNeighbour;
        }
}

void listLooks(const TriangleMesh& mesh, FractureGeometry& geometry) {
    const bool any = std::any_of(mesh.corners.begin(), mesh.corners.end(),
                                 [](const auto& corners) { return corners[0].material != kNoMaterial; });
    if (!any) return;
    for (const auto& [a, b, c] : mesh.corners)
        geometry.looks.push_back({{a.uv, b.uv, c.uv},
                                  {a.second_uv, b.second_uv, c.second_uv},
                                  {a.colour, b.colour, c.colour},
                                  a.material});
}

/// Rows of a CSR from (row, entry) in the order given.
template <class Visit>
std::vector<uint32_t> rowStarts(size_t rows, const Visit& visit_rows) {
    std::vector<uint32_t> start(rows + 1, 0);
    visit_rows([&](uint32_t row) { ++start[row + 1]; });
    for (size_t r = 0; r < rows; ++r) start[r + 1] += start[r];
    return start;
}

void listCorners(FractureGeometry& geometry) {
    const auto forEachPart = [&](const auto& visit) {
        for (size_t i = 0; i < geometry.exterior_indices.size(); i += 3) {
            std::array<uint32_t, 3> p{};
            for (size_t k = 0; k < 3; ++k)
                p[k] = geometry.exterior_home[geometry.exterior_indices[i + k]].point;
            if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) visit(p);
        }
    };
    geometry.point_corner_start = rowStarts(geometry.points.size(), [&](const auto& count) {
        forEachPart([&](const auto& p) {
            for (const uint32_t point : p) count(point);
        });
    });
    std::vector<uint32_t> cursor(geometry.point_corner_start.begin(), geometry.point_corner_start.end() - 1);
    geometry.point_corner_next.resize(geometry.point_corner_start.back());
    geometry.point_corner_previous.resize(geometry.point_corner_start.back());
    forEachPart([&](const auto& p) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t at = cursor[p[k]]++;
            geometry.point_corner_next[at] = p[(k + 1) % 3];
            geometry.point_corner_previous[at] = p[(k + 2) % 3];
        }
    });
}

void listCracks(FractureGeometry& geometry) {
    const auto forEachEnd = [&](const auto& visit) {
        for (uint32_t e = 0; e < geometry.crack_edges.size(); ++e) {
            const CrackEdge& edge = geometry.crack_edges[e];
            const uint32_t a = geometry.exterior_home[edge.vertex_0].point;
            const uint32_t b = geometry.exterior_home[edge.vertex_1].point;
            if (a == b) continue;
            visit(a, PointCrack{e, b});
            visit(b, PointCrack{e, a});
        }
    };
    geometry.point_crack_start = rowStarts(geometry.points.size(), [&](const auto& count) {
        forEachEnd([&](uint32_t point, const PointCrack&) { count(point); });
    });
    std::vector<uint32_t> cursor(geometry.point_crack_start.begin(), geometry.point_crack_start.end() - 1);
    geometry.point_cracks.resize(geometry.point_crack_start.back());
    forEachEnd(
        [&](uint32_t point, const PointCrack& crack) { geometry.point_cracks[cursor[point]++] = crack; });
}

}  // namespace

void listOutsidePoints(const TriangleMesh& mesh, const CellComplex& complex,
                       const std::vector<uint32_t>& corner_vertex,
                       const std::vector<uint32_t>& pool_of_vertex, FractureGeometry& geometry) {
    numberPoints(mesh, complex, corner_vertex, pool_of_vertex, geometry);
    listTriangles(mesh, geometry);
    listLooks(mesh, geometry);
    listCorners(geometry);
    listCracks(geometry);
}

}  // namespace demolish
