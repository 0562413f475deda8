// SPDX-License-Identifier: Apache-2.0
// A solid and a particle count in, a breakable body out: the stages of authoring in order.
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/border_teeth.h"
#include "sim_cuda/authoring/cell_corners.h"
#include "sim_cuda/authoring/conforming.h"
#include "sim_cuda/authoring/packing.h"
#include "sim_cuda/authoring/painted_bonds.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "sim_cuda/authoring/struck_place.h"

namespace demolish {
namespace {

/// Passes the fraction on, scaled to the stage's share of the whole (measured shares of geometry.md 2.5).
class Stages {
  public:
    explicit Stages(const ProgressCallback& callback) : callback_(callback) {}
    void enter(const char* name, double begin, double end) {
        name_ = name;
        begin_ = begin;
        end_ = end;
        if (!tell(0)) throw Cancelled();
    }
    bool tell(double fraction) const {
        return !callback_ || callback_(begin_ + fraction * (end_ - begin_), name_);
    }

  private:
    const ProgressCallback& callback_;
    const char* name_ = "";
    double begin_ = 0, end_ = 0;
};

void requirePossibleCount(uint32_t count) {
    if (count < kMinParticles || count > kMaxParticles)
        throw UsageError("A body needs " + std::to_string(kMinParticles) + " to " +
                         std::to_string(kMaxParticles) + " particles, not " + std::to_string(count) + ".");
}

/// Where a surface goes through itself its inside can count as outside: cells come out with no volume or
/// less, and nothing can be made of them.
std::ptrdiff_t cellsWithoutVolume(const std::vector<Particle>& particles) {
    return std::count_if(particles.begin(), particles.end(),
                         [](const Particle& particle) { return !(particle.volume > 0); });
}

void requireVolumes(const std::string& name, const std::vector<Particle>& particles) {
    if (const std::ptrdiff_t empty = cellsWithoutVolume(particles))
        throw InputFileError("The model '" + name + "' is inside out in places (" + std::to_string(empty) +
                             " of " + std::to_string(particles.size()) +
                             " cells have no volume); turn the faces of those parts round.");
}

/// Seeds, and what they were laid out by.
struct Packed {
    SpacingField spacing;
    std::unique_ptr<const ToughField> tough;  // null: the solver draws tough cells
    std::vector<Double3> seeds;
};

/// m
constexpr double kRefineReach = 0.5;  // of the longest side
constexpr double kAimReach = 0.05;    // of the longest side: so near a line counts as met

double longestSide(const SolidMeshInfo& info) {
    const Double3 size = info.bounds_max - info.bounds_min;
    return std::max({size.x, size.y, size.z});
}

/// What is too thin for the grid stays even.
SpacingField spacingFieldOf(const SolidMesh& solid, const FillOptions& options, double even) {
    const std::vector<Double3>& nodes = solid.grid().insideNodesInMortonOrder();
    if (!(options.refine > 1) || nodes.empty()) return SpacingField(even);
    const double side = longestSide(solid.info());
    return {options.refine, struckPlace(options.aim, nodes, kAimReach * side), kRefineReach * side,
            even * even * even, solid.grid()};
}

Double3 patternCentre(const SolidMesh& solid, const FillOptions& options, const std::vector<Double3>& seeds) {
    if (options.tough->pattern == Pattern::kRadial)
        return struckPlace(options.aim, seeds, kAimReach * longestSide(solid.info()));
    return 0.5 * (solid.info().bounds_min + solid.info().bounds_max);
}

Packed packed(const SolidMesh& solid, const FillOptions& options, double even, const Stages& stages) {
    const bool conforms = options.tough && options.tough->conform;
    const double relaxed = conforms ? 0.4 : 1;  // of the stage
    Packed made{spacingFieldOf(solid, options, even), nullptr, {}};
    const auto layTough = [&](std::vector<Double3>& seeds) {
        if (!options.tough) return;
        made.tough = makeToughField(*options.tough, patternCentre(solid, options, seeds), seeds,
                                    solid.info().volume, even, options.seed);
        if (made.tough == nullptr || !conforms) return;
        conformSeeds({*made.tough, solid.grid(), made.spacing}, options.seed, seeds, [&](double fraction) {
            if (!stages.tell(relaxed + (1 - relaxed) * fraction)) throw Cancelled();
        });
    };
    made.seeds = packSeeds(
        solid.mesh(), solid.queries(), solid.grid(), made.spacing, options.particles, options.seed,
        [&](double fraction) { return stages.tell(relaxed * fraction); }, layTough);
    return made;
}

std::vector<double> cellSpacings(const SpacingField& field, const std::vector<Double3>& seeds) {
    std::vector<double> spacings;
    if (field.isEven()) return spacings;
    for (const Double3& seed : seeds) spacings.push_back(field.at(seed));
    return spacings;
}

std::vector<uint32_t> cellsAt(const ToughField& tough, const std::vector<Double3>& seeds) {
    std::vector<uint32_t> cells;
    for (const Double3& seed : seeds) cells.push_back(tough.cellAt(seed));
    return cells;
}

/// How toothed the borders are that the same packing has before it follows them.
double teethWithoutConforming(const SolidMesh& solid, const FillOptions& options, double even,
                              const Packed& packing) {
    const CellComplex complex = buildCellComplex(solid.mesh(), solid.queries(),
                                                 packSeeds(solid.mesh(), solid.queries(), solid.grid(),
                                                           packing.spacing, options.particles, options.seed),
                                                 even, options.seed);
    const auto bonds = makeBonds(complex, even, cellSpacings(packing.spacing, complex.seeds));
    return borderTeeth(*packing.tough, bonds, cellsAt(*packing.tough, complex.seeds), even);
}

void layToughCells(const SolidMesh& solid, const FillOptions& options, const Packed& packing,
                   const std::vector<Double3>& seeds, BreakableBody& body) {
    if (packing.tough == nullptr) return;
    body.tough_cell = cellsAt(*packing.tough, seeds);
    if (!options.tough->conform) return;
    body.border_strength = teethWithoutConforming(solid, options, body.spacing, packing) /
                           borderTeeth(*packing.tough, body.bonds, body.tough_cell, body.spacing);
}

/// Null where cells came out open or without volume and a new surface may mend that.
std::shared_ptr<const BreakableBody> filled(const SolidMesh& solid, const FillOptions& options,
                                            const ProgressCallback& progress) {
    const SolidMeshInfo& info = solid.info();
    const double spacing = std::cbrt(info.volume / options.particles);
    Stages stages(progress);

    stages.enter("Packing particles", 0, 0.2);
    Packed packing = packed(solid, options, spacing, stages);
    stages.enter("Cutting cells", 0.2, 0.65);
    const CellComplex complex =
        buildCellComplex(solid.mesh(), solid.queries(), std::move(packing.seeds), spacing, options.seed);

    stages.enter("Weighing cells", 0.65, 0.72);
    auto body = std::make_shared<BreakableBody>();
    body->name = info.name;
    body->remeshed = solid.repair().remeshed == RemeshCause::kCells;
    body->particles = massProperties(solid.mesh(), solid.queries(), complex);
    const bool is_sound = complex.open_cells.empty() && cellsWithoutVolume(body->particles) == 0;
    if (!is_sound && solid.withNewSurface() != nullptr) return nullptr;
    requireVolumes(info.name, body->particles);
    stages.enter("Bonding cells", 0.72, 0.78);
    body->spacing = spacing;
    body->cell_spacing = cellSpacings(packing.spacing, complex.seeds);
    body->bonds = makeBonds(complex, spacing, body->cell_spacing);
    layToughCells(solid, options, packing, complex.seeds, *body);
    if (options.painted)
        body->bond_strength =
            paintedBonds(solid.mesh(), solid.queries(), complex.seeds, body->bonds, *options.painted);
    body->corners = cellCorners(complex, spacing);
    stages.enter("Making crack surfaces", 0.78, 1);
    if (options.draw_geometry) {
        body->geometry = makeFractureGeometry(solid.mesh(), complex, body->bonds, body->cell_spacing);
        body->looks = solid.looks();
    }

    body->mesh_volume = info.volume;
    for (const Particle& particle : body->particles) body->cells_volume += particle.volume;
    body->mesh_area = info.area;
    body->bounds_min = info.bounds_min;
    body->bounds_max = info.bounds_max;
    body->open_cells = uint32_t(complex.open_cells.size());
    if (!stages.tell(1)) throw Cancelled();
    return body;
}

}  // namespace

std::shared_ptr<const BreakableBody> fillWithParticles(const SolidMesh& solid, const FillOptions& options,
                                                       const ProgressCallback& progress) {
    requirePossibleCount(options.particles);
    const auto body = filled(solid, options, progress);
    return body != nullptr ? body : filled(*solid.withNewSurface(), options, progress);
}

}  // namespace demolish
