// SPDX-License-Identifier: Apache-2.0
// A solid and a particle count in, a breakable body out: the stages of authoring in order.
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/cell_corners.h"
#include "sim_cuda/authoring/packing.h"
#include "sim_cuda/authoring/solid_mesh.h"

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

/// Null where cells came out open or without volume and a new surface may mend that.
std::shared_ptr<const BreakableBody> filled(const SolidMesh& solid, const FillOptions& options,
                                            const ProgressCallback& progress) {
    const SolidMeshInfo& info = solid.info();
    const double spacing = std::cbrt(info.volume / options.particles);
    Stages stages(progress);

    stages.enter("Packing particles", 0, 0.2);
    std::vector<Double3> seeds =
        packSeeds(solid.mesh(), solid.queries(), solid.grid(), info.volume, options.particles, options.seed,
                  [&](double fraction) { return stages.tell(fraction); });
    stages.enter("Cutting cells", 0.2, 0.65);
    const CellComplex complex =
        buildCellComplex(solid.mesh(), solid.queries(), std::move(seeds), spacing, options.seed);

    stages.enter("Weighing cells", 0.65, 0.72);
    auto body = std::make_shared<BreakableBody>();
    body->name = info.name;
    body->remeshed = solid.repair().remeshed == RemeshCause::kCells;
    body->particles = massProperties(solid.mesh(), solid.queries(), complex);
    const bool is_sound = complex.open_cells.empty() && cellsWithoutVolume(body->particles) == 0;
    if (!is_sound && solid.withNewSurface() != nullptr) return nullptr;
    requireVolumes(info.name, body->particles);
    stages.enter("Bonding cells", 0.72, 0.78);
    body->bonds = makeBonds(complex, spacing);
    body->corners = cellCorners(complex, spacing);
    stages.enter("Making crack surfaces", 0.78, 1);
    if (options.draw_geometry) {
        body->geometry = makeFractureGeometry(solid.mesh(), complex, body->bonds);
        body->looks = solid.looks();
    }

    body->spacing = spacing;
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
