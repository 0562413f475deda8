// SPDX-License-Identifier: Apache-2.0
// From the cell complex to what is drawn: the order of the steps, and the length that faces are tessellated
// at.
#include <cmath>

#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/fracture_geometry_parts.h"

namespace demolish {
namespace {

/// Longest part of a Voronoi edge over h. Edges are 0.4 h on average: half of them stay whole, the long ones
/// are cut, and with the centre vertex a face gets about eight triangles.
constexpr double kLongestPart = 0.45;

/// How far points of the outside slide, over h: less where a wall has few cells across it.
constexpr double kReachOnWalls = 0.45, kReachOnSolids = 0.7, kThinWall = 2.5;

double enclosedVolume(const TriangleMesh& mesh) {
    double six_volumes = 0;
    for (const auto& t : mesh.triangles)
        six_volumes += dot(mesh.positions[t[0]], cross(mesh.positions[t[1]], mesh.positions[t[2]]));
    return six_volumes / 6;
}

double area(const TriangleMesh& mesh) {
    double twice = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        twice += length(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
    return twice / 2;
}

/// A wall between two outsides is as thick as its volume over half of its area.
void setReach(const TriangleMesh& mesh, double spacing, const std::vector<double>& cell_spacing,
              FractureGeometry& geometry) {
    const double thickness = 2 * enclosedVolume(mesh) / area(mesh);
    for (OutsidePoint& point : geometry.points) {
        const double own = cell_spacing.empty() ? spacing : cell_spacing[point.cell];
        point.spacing = static_cast<float>(own);
        point.reach =
            static_cast<float>((thickness < kThinWall * own ? kReachOnWalls : kReachOnSolids) * own);
    }
}

}  // namespace

BondLookup::BondLookup(const std::vector<BondGeometry>& bonds, size_t cell_count)
    : start_(cell_count + 1, 0) {
    higher_.reserve(bonds.size());
    for (const BondGeometry& bond : bonds) {
        ++start_[bond.i + 1];
        higher_.push_back(bond.j);
    }
    for (size_t cell = 0; cell < cell_count; ++cell) start_[cell + 1] += start_[cell];
}

uint32_t BondLookup::find(uint32_t i, uint32_t j) const {
    for (uint32_t b = start_[i]; b < start_[i + 1]; ++b)
        if (higher_[b] == j) return b;
    return kNoBond;
}

FractureGeometry makeFractureGeometry(const TriangleMesh& mesh, const CellComplex& complex,
                                      const std::vector<BondGeometry>& bonds,
                                      const std::vector<double>& cell_spacing) {
    const double spacing = std::cbrt(enclosedVolume(mesh) / static_cast<double>(complex.seeds.size()));
    const BondLookup lookup(bonds, complex.seeds.size());
    FractureGeometry geometry;
    const std::vector<uint32_t> corner_vertex = makeExterior(mesh, complex, lookup, geometry);
    const std::vector<uint32_t> pool_of_vertex =
        tessellateFaces(complex, splitVoronoiEdges(complex, kLongestPart * spacing), lookup, geometry);
    listPoolCorners(geometry);
    listOutsidePoints(mesh, complex, corner_vertex, pool_of_vertex, geometry);
    setReach(mesh, spacing, cell_spacing, geometry);
    return geometry;
}

}  // namespace demolish
