// SPDX-License-Identifier: Apache-2.0
// What authoring makes of a mesh and a particle size: particles, bonds, geometry to draw. SI units, y up.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim_cuda/api/fracture_geometry.h"
#include "sim_cuda/api/model_looks.h"
#include "sim_cuda/api/vectors.h"

namespace demolish {

/// One Voronoi cell clipped by the surface. The particle sits at its seed.
struct Particle {
    Double3 seed;               ///< m, body frame
    Double3 centroid;           ///< m, centre of mass of the cell
    SymmetricTensor inertia;    ///< m^5, about the centroid, at unit density
    double volume = 0;          ///< m^3
    double depth = 0;           ///< m, distance of the seed from the surface, > 0 inside
    double lowest = 0;          ///< m, height (y) of the cell's lowest point
    double contact_radius = 0;  ///< m, of a sphere, for all contacts; 0: from the seeds and the surface
};

/// One shared face area inside the solid (geometry.md 5). i < j; the face lies on the seeds' bisector.
struct BondGeometry {
    uint32_t i = 0, j = 0;
    double area = 0;    ///< m^2, summed over the parts of the face
    Double3 centroid;   ///< m, area centroid of the face
    Double3 normal;     ///< unit, (x_j - x_i) / L
    double length = 0;  ///< m, L = |x_j - x_i|
};

/// Corners of a cell at most: a Voronoi cell has some 37. On 16 it lies to 0.17 h deeper than it is drawn.
inline constexpr uint32_t kMostCorners = 24;

/// What of the cells meets floors and other colliders. Those of cell i: start[i] .. start[i+1]-1.
struct CellCorners {
    std::vector<uint32_t> start;     ///< cells + 1; empty: the cells meet colliders as spheres
    std::vector<Double3> from_seed;  ///< m, body frame
};

/// The next cell is a box: `low` and `high` in m from its seed.
inline void appendBoxCorners(CellCorners& corners, const Double3& low, const Double3& high) {
    if (corners.start.empty()) corners.start.push_back(0);
    for (const double x : {low.x, high.x})
        for (const double y : {low.y, high.y})
            for (const double z : {low.z, high.z}) corners.from_seed.push_back({x, y, z});
    corners.start.push_back(static_cast<uint32_t>(corners.from_seed.size()));
}

struct BreakableBody {
    std::string name;
    std::vector<Particle> particles;  ///< index = cell id = particle id within the body
    std::vector<BondGeometry> bonds;  ///< sorted by (i, j); none below 0.02 h^2
    CellCorners corners;
    /// Of each particle a word for the tough cell that it is of; empty: the solver draws tough cells.
    std::vector<uint32_t> tough_cell;
    /// Of bonds between those, times what all others have: as strong against a straight cut as the teeth of a
    /// packing that knows no borders, which have more area (models E.3).
    double border_strength = 1;
    /// Of each bond, times its strength: as painted on the outside above it; empty: 1.
    std::vector<double> bond_strength;
    FractureGeometry geometry;
    std::shared_ptr<const ModelLooks> looks;  ///< of the model file; null: it has none
    double spacing = 0;                       ///< m, h = (V / N)^(1/3)
    std::vector<double> cell_spacing;         ///< m, round each particle where sizes are graded; else empty
    double mesh_volume = 0;                   ///< m^3
    double cells_volume = 0;                  ///< m^3, sum over the cells; equals mesh_volume to 1e-9
    double mesh_area = 0;                     ///< m^2
    Double3 bounds_min, bounds_max;           ///< m
    bool remeshed = false;    ///< filled within a new surface, since its cells came out unsound in the mesh's
    uint32_t open_cells = 0;  ///< with an unbalanced edge after the re-jitter fall-back; 0 unless logged
};

}  // namespace demolish
