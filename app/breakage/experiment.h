// SPDX-License-Identifier: Apache-2.0
// Values of a breakage experiment (the paper's 4.1): specimens, material, wall, sweep, what counts as broken.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "app/breakage/outcome.h"
#include "app/session/shot.h"
#include "sim_cuda/api/params.h"
#include "sim_cuda/api/sphere_specimen.h"

namespace demolish {

/// One reading of the experiment: a line on the plots. SI units; ranges in visitValues().
struct BreakageExperiment {
    std::string name = "breakage";  ///< of its file
    std::string title;              ///< in legends
    std::string why;                ///< what is read differently, and what speaks for it

    std::array<double, 2> diameters{24e-6, 36e-6};  ///< m, small before large
    uint32_t packings = 30;                         ///< of each size
    uint32_t grains = 1000;                         ///< in the small specimen
    bool scaled_grains = false;  ///< the large one has as many grains, not grains of the same size
    double solid_fraction = 0.60, radius_scatter = 0.12, bond_gap = 0.30;  ///< as in SphereSpecimen
    uint32_t seed = 1;

    double density = 3900;          ///< kg/m^3, of the grains
    double youngs_modulus = 200e9;  ///< Pa
    double poisson_ratio = 0.25;
    double bond_ratio = 0.5;         ///< a*
    double fracture_energy = 8.5;    ///< J/m^2, Gamma of (13)
    double large_energy_factor = 1;  ///< times that, in the large specimen
    double friction = 0.3, restitution = 0.7, damping_ratio = 0.16;
    double wall_friction = -1;  ///< negative: the grains' own
    double wall_stiffness = 1;  ///< share of a rigid wall's; 0.5: (1) as printed

    double slowest = 25, fastest = 47.5;  ///< m/s
    uint32_t velocities = 10;             ///< evenly spaced, both ends included
    double duration = 80e-9;              ///< s simulated from just before the impact on
    double step_safety = 0.5;             ///< of the critical step

    BreakRule rule = BreakRule::kLargest;
    Criteria criteria;
};

/// visit(key, value, range) for every number; the key is its place in the file.
template <class Experiment, class Visit>
void visitValues(Experiment& e, Visit&& visit) {
    visit("specimen.small_m", e.diameters[0], Range{1e-7, 10});
    visit("specimen.large_m", e.diameters[1], Range{1e-7, 10});
    visit("specimen.packings", e.packings, Range{1, 1000});
    visit("specimen.grains", e.grains, Range{20, 20000});
    visit("specimen.solid_fraction", e.solid_fraction, Range{0.3, 0.62});
    visit("specimen.radius_scatter", e.radius_scatter, Range{0, 0.5});
    visit("specimen.bond_gap", e.bond_gap, Range{0, 0.4});
    visit("specimen.seed", e.seed, Range{0, 4294967295.0});
    visit("material.density_kg_m3", e.density, Range{1, 30000});
    visit("material.youngs_modulus_pa", e.youngs_modulus, Range{1e3, 1e13});
    visit("material.poisson_ratio", e.poisson_ratio, Range{0, 0.49});
    visit("material.bond_ratio", e.bond_ratio, Range{0.1, 0.9});
    visit("material.fracture_energy_j_m2", e.fracture_energy, Range{1e-6, 1e6});
    visit("material.large_energy_factor", e.large_energy_factor, Range{0.1, 10});
    visit("material.friction", e.friction, Range{0, 1.5});
    visit("material.restitution", e.restitution, Range{0.05, 0.95});
    visit("material.damping_ratio", e.damping_ratio, Range{0, 0.6});
    visit("wall.friction", e.wall_friction, Range{-1, 1.5});
    visit("wall.stiffness", e.wall_stiffness, Range{0.01, 1});
    visit("impact.slowest_mps", e.slowest, Range{0.01, 1000});
    visit("impact.fastest_mps", e.fastest, Range{0.01, 1000});
    visit("impact.velocities", e.velocities, Range{1, 200});
    visit("impact.duration_s", e.duration, Range{1e-8, 1});
    visit("impact.step_safety", e.step_safety, Range{0.05, 0.7});
    visit("broken.intact_share", e.criteria.intact_share, Range{0.1, 1});
    visit("broken.child_share", e.criteria.child_share, Range{1e-4, 0.5});
    visit("broken.flaps", e.criteria.flaps, Range{2, 7});
    visit("broken.slabs", e.criteria.slabs, Range{2, 50});
}

/// From a file; `like` names another one beside it from which it takes what it does not say itself. Throws
/// InputFileError with file and line.
BreakageExperiment loadExperiment(const std::filesystem::path& file);
/// A name of assets/experiments, or a file's path (ends in .toml). Throws UsageError with the names there
/// are.
BreakageExperiment findExperiment(const std::string& name_or_file);
/// Of the readings that the program ships, the default one first.
std::vector<std::string> experimentNames();

/// m/s, ascending.
std::vector<double> velocitiesOf(const BreakageExperiment& experiment);
/// Of one size (0 small, 1 large) and packing.
SphereSpecimen specimenOf(const BreakageExperiment& experiment, uint32_t size, uint32_t packing);
/// Of one size.
Material materialOf(const BreakageExperiment& experiment, uint32_t size);

/// Every value, exactly; experimentFromJson gives the same experiment back.
std::string experimentJson(const BreakageExperiment& experiment);
/// Throws InputFileError when the text is not such a record.
BreakageExperiment experimentFromJson(const std::string& text);

}  // namespace demolish
