// SPDX-License-Identifier: Apache-2.0
// Faces in order of the nodes, vertices of the cells in parallel.
#include "sim_cuda/authoring/repair/dual_contouring.h"

#include <tbb/parallel_for.h>

namespace demolish {
namespace {

constexpr double kPull = 0.03;    // of each crossing towards their mean, or flat places would slide
constexpr double kOnPlane = 0.7;  // steps: farther triangles say nothing about the surface here
constexpr uint32_t kNone = 0xffffffffu;

/// Normal equations of the least squares problem: the sum of (n (x - p))^2.
class PlaneFit {
  public:
    void add(const Double3& normal, double offset) {
        xx_ += normal.x * normal.x, xy_ += normal.x * normal.y, xz_ += normal.x * normal.z;
        yy_ += normal.y * normal.y, yz_ += normal.y * normal.z, zz_ += normal.z * normal.z;
        right_ += normal * offset;
    }
    /// With `pull` times x^2 added, which makes it solvable.
    Double3 solved(double pull) const {
        const Double3 a{xx_ + pull, xy_, xz_}, b{xy_, yy_ + pull, yz_}, c{xz_, yz_, zz_ + pull};
        return Double3{dot(right_, cross(b, c)), dot(right_, cross(c, a)), dot(right_, cross(a, b))} *
               (1 / dot(a, cross(b, c)));
    }

  private:
    double xx_ = 0, xy_ = 0, xz_ = 0, yy_ = 0, yz_ = 0, zz_ = 0;
    Double3 right_;
};

struct Contour {
    const std::vector<float>& field;
    const NodeFrame& frame;
    const TriangleMesh& original;
    const MeshQueries& queries;

    float at(const std::array<int, 3>& node) const { return field[frame.index(node[0], node[1], node[2])]; }
    Double3 place(const std::array<int, 3>& node) const { return frame.node(node[0], node[1], node[2]); }
};

/// Where the surface passes a grid edge, and the plane of the original there; no normal where none is near.
struct Crossing {
    Double3 point, normal;
};

Crossing crossingOn(const Contour& contour, const std::array<int, 3>& a, const std::array<int, 3>& b) {
    const double fa = contour.at(a), fb = contour.at(b), along = fa / (fa - fb);
    Crossing crossing{contour.place(a) * (1 - along) + contour.place(b) * along, {}};
    const double reach = kOnPlane * contour.frame.step;
    const ClosestPoint nearest = contour.queries.closestPoint(crossing.point, reach);
    if (nearest.triangle == kNoTriangle) return crossing;
    const auto& k = contour.original.triangles[nearest.triangle];
    const auto& p = contour.original.positions;
    return {nearest.point, normalized(cross(p[k[1]] - p[k[0]], p[k[2]] - p[k[0]]))};
}

/// Numbers the cells that the surface passes, and joins them over the grid edges that it crosses.
class Faces {
  public:
    explicit Faces(const Contour& contour)
        : contour_(contour), ids_(contour.frame.size(), kNone), face_over_(3 * contour.frame.size(), kNone) {
        const NodeFrame& frame = contour.frame;
        for (int z = 1; z + 1 < frame.nz; ++z)
            for (int y = 1; y + 1 < frame.ny; ++y)
                for (int x = 1; x + 1 < frame.nx; ++x)
                    for (size_t axis = 0; axis < 3; ++axis) addFace({x, y, z}, axis);
    }
    std::vector<Triangle> triangles;
    std::vector<std::array<int, 3>> cells;  // by vertex
    struct Edge {
        std::array<int, 3> node;  // from here along the axis
        size_t axis;
    };
    std::vector<Edge> edges;  // by face

    /// kNone where the surface does not pass the edge from the node along the axis.
    uint32_t faceOver(const std::array<int, 3>& node, size_t axis) const {
        return face_over_[3 * contour_.frame.index(node[0], node[1], node[2]) + axis];
    }

  private:
    uint32_t vertexOf(const std::array<int, 3>& cell) {
        uint32_t& id = ids_[contour_.frame.index(cell[0], cell[1], cell[2])];
        if (id == kNone) {
            id = uint32_t(cells.size());
            cells.push_back(cell);
        }
        return id;
    }
    /// The four cells about the edge from the node along the axis, counter-clockwise seen from outside.
    void addFace(const std::array<int, 3>& node, size_t axis) {
        std::array<int, 3> next = node;
        ++next[axis];
        const bool inside = contour_.at(node) < 0;
        if (inside == (contour_.at(next) < 0)) return;
        face_over_[3 * contour_.frame.index(node[0], node[1], node[2]) + axis] = uint32_t(edges.size());
        edges.push_back({node, axis});
        std::array<uint32_t, 4> v;
        for (size_t i = 0; i < 4; ++i) {
            std::array<int, 3> cell = node;
            cell[(axis + 1) % 3] -= i == 0 || i == 3;
            cell[(axis + 2) % 3] -= i < 2;
            v[i] = vertexOf(cell);
        }
        if (!inside) std::swap(v[1], v[3]);
        triangles.push_back({v[0], v[1], v[2]});
        triangles.push_back({v[0], v[2], v[3]});
    }

    const Contour& contour_;
    std::vector<uint32_t> ids_;        // by the cell's first node
    std::vector<uint32_t> face_over_;  // three by node: along x, y, z
};

/// Vertex of a cell, from where the surface passes its edges.
Double3 vertexIn(const Contour& contour, const std::array<int, 3>& cell, const Faces& faces,
                 const std::vector<Crossing>& crossing_of_face) {
    std::array<Crossing, 12> crossings;
    size_t count = 0;
    for (size_t axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 4; ++side) {
            std::array<int, 3> node = cell;
            node[(axis + 1) % 3] += side & 1;
            node[(axis + 2) % 3] += side >> 1;
            const uint32_t face = faces.faceOver(node, axis);
            if (face != kNone) crossings[count++] = crossing_of_face[face];
        }
    Double3 mean;
    for (size_t i = 0; i < count; ++i) mean += crossings[i].point * (1.0 / double(count));
    PlaneFit fit;
    for (size_t i = 0; i < count; ++i)
        fit.add(crossings[i].normal, dot(crossings[i].normal, crossings[i].point - mean));
    const Double3 lower = contour.place(cell), upper = contour.place({cell[0] + 1, cell[1] + 1, cell[2] + 1});
    return maximum(lower, minimum(upper, mean + fit.solved(kPull * double(count))));
}

}  // namespace

TriangleMesh dualContour(const std::vector<float>& field, const NodeFrame& frame,
                         const TriangleMesh& original, const MeshQueries& queries) {
    const Contour contour{field, frame, original, queries};
    Faces faces(contour);
    TriangleMesh surface;
    surface.name = original.name;
    surface.triangles = std::move(faces.triangles);
    surface.positions.resize(faces.cells.size());
    std::vector<Crossing> crossings(faces.edges.size());
    tbb::parallel_for(size_t(0), crossings.size(), [&](size_t face) {
        const auto& [node, axis] = faces.edges[face];
        std::array<int, 3> next = node;
        ++next[axis];
        crossings[face] = crossingOn(contour, node, next);
    });
    tbb::parallel_for(size_t(0), faces.cells.size(), [&](size_t i) {
        surface.positions[i] = vertexIn(contour, faces.cells[i], faces, crossings);
    });
    return surface;
}

}  // namespace demolish
