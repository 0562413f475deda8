// SPDX-License-Identifier: Apache-2.0
// Radii, packing, bonds across gaps.
#include "sim_cuda/api/sphere_specimen.h"

#include <algorithm>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/seed_grid.h"
#include "sim_cuda/authoring/sphere_packing.h"
#include "sim_cuda/physics/bond_stiffness.h"

namespace demolish {
namespace {

constexpr uint64_t kRadiusStream = 72;

void demand(bool condition, const char* sentence) {
    if (!condition) throw UsageError(sentence);
}

void check(const SphereSpecimen& s) {
    demand(s.diameter > 0 && s.diameter < 1e3, "A specimen's diameter must lie between 0 and 1000 m.");
    demand(s.grains >= 2 && s.grains <= 100'000, "A specimen has 2 to 100,000 grains.");
    demand(s.solid_fraction >= 0.05 && s.solid_fraction <= 0.62,
           "A specimen's solid fraction must lie between 0.05 and 0.62.");
    demand(s.radius_scatter >= 0 && s.radius_scatter <= 0.5,
           "The scatter of a specimen's radii must lie between 0 and 0.5.");
    demand(s.bond_gap >= 0 && s.bond_gap <= 0.4, "The gap of a specimen's bonds must lie between 0 and 0.4.");
    demand(s.bond_ratio >= 0.1 && s.bond_ratio <= 0.9,
           "The ratio a* of a specimen's bonds must lie between 0.1 and 0.9.");
}

double cube(double x) {
    return x * x * x;
}
double ballVolume(double radius) {
    return 4.0 / 3 * kPi * cube(radius);
}

std::vector<double> grainRadii(const SphereSpecimen& s) {
    std::vector<double> radii(s.grains);
    double sum = 0;
    for (uint32_t i = 0; i < s.grains; ++i) {
        radii[i] = 1 + s.radius_scatter * (2 * hashRandom(s.seed, kRadiusStream, i) - 1);
        sum += cube(radii[i]);
    }
    const double scale = s.diameter / 2 * std::cbrt(s.solid_fraction / sum);
    for (double& radius : radii) radius *= scale;
    return radii;
}

struct Neighbour {
    uint32_t i, j;
    double distance;  ///< m
};

/// Pairs i < j whose gap is at most `gap` (R1 + R2), sorted.
std::vector<Neighbour> neighbours(const std::vector<Double3>& places, const std::vector<double>& radii,
                                  double gap) {
    const double largest = *std::max_element(radii.begin(), radii.end());
    const SeedGrid grid(places, 2 * largest * (1 + gap));
    std::vector<Neighbour> found;
    for (uint32_t i = 0; i < places.size(); ++i)
        for (int ring = 0; ring <= 1; ++ring)
            grid.visitRing(grid.placeOf(places[i]), ring, [&](uint32_t j, const Double3& other) {
                const double distance = length(other - places[i]);
                if (j > i && distance <= (1 + gap) * (radii[i] + radii[j])) found.push_back({i, j, distance});
            });
    std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) {
        return std::pair(a.i, a.j) < std::pair(b.i, b.j);
    });
    return found;
}

void addGrains(const SphereSpecimen& s, const std::vector<Double3>& places, const std::vector<double>& radii,
               BreakableBody& body) {
    for (uint32_t i = 0; i < places.size(); ++i) {
        Particle grain;
        grain.seed = grain.centroid = places[i];
        grain.volume = ballVolume(radii[i]);
        const double moment = 0.4 * grain.volume * radii[i] * radii[i];
        grain.inertia = {moment, moment, moment, 0, 0, 0};
        grain.depth = s.diameter / 2 - length(places[i]);
        grain.lowest = places[i].y - radii[i];
        grain.contact_radius = radii[i];
        body.particles.push_back(grain);
        body.cells_volume += grain.volume;
    }
}

/// What the packing left of overlap goes from the contact radii: R_c,i + R_c,j <= distance for all pairs
/// (physics A.6).
void shrinkContactRadii(const std::vector<Neighbour>& pairs, const std::vector<double>& radii,
                        BreakableBody& body) {
    for (const Neighbour& pair : pairs) {
        const double share = pair.distance / (radii[pair.i] + radii[pair.j]);
        for (const uint32_t i : {pair.i, pair.j})
            body.particles[i].contact_radius = std::min(body.particles[i].contact_radius, share * radii[i]);
    }
}

void addBonds(const SphereSpecimen& s, const std::vector<Neighbour>& pairs, const std::vector<double>& radii,
              BreakableBody& body) {
    for (const Neighbour& pair : pairs) {
        const double bond_radius = sphereBondRadius(s.bond_ratio, radii[pair.i], radii[pair.j]);
        const Double3 &from = body.particles[pair.i].seed, &to = body.particles[pair.j].seed;
        BondGeometry bond;
        bond.i = pair.i;
        bond.j = pair.j;
        bond.area = kPi * bond_radius * bond_radius;
        bond.centroid = 0.5 * (from + to);
        bond.normal = normalized(to - from);
        bond.length = pair.distance;
        body.bonds.push_back(bond);
    }
}

}  // namespace

std::shared_ptr<const BreakableBody> packSphereSpecimen(const SphereSpecimen& specimen) {
    check(specimen);
    const std::vector<double> radii = grainRadii(specimen);
    const double radius = specimen.diameter / 2;
    const std::vector<Double3> places = packSpheres(radii, radius, specimen.seed);
    const std::vector<Neighbour> pairs = neighbours(places, radii, specimen.bond_gap);
    auto body = std::make_shared<BreakableBody>();
    body->name = "specimen";
    addGrains(specimen, places, radii, *body);
    shrinkContactRadii(pairs, radii, *body);
    addBonds(specimen, pairs, radii, *body);
    body->mesh_volume = ballVolume(radius);
    body->spacing = std::cbrt(body->mesh_volume / specimen.grains);
    body->mesh_area = 4 * kPi * radius * radius;
    body->bounds_min = {-radius, -radius, -radius};
    body->bounds_max = {radius, radius, radius};
    return body;
}

double coordinationOf(const BreakableBody& body) {
    return 2 * static_cast<double>(body.bonds.size()) / static_cast<double>(body.particles.size());
}

}  // namespace demolish
