// SPDX-License-Identifier: Apache-2.0
// What each body throws off, in the numbers that kernels take: its material's amounts at its own particle
// spacing.
#pragma once
#include <cmath>
#include <vector>

#include "sim_cuda/api/solver.h"
#include "sim_cuda/effects/grain.h"
#include "sim_cuda/effects/size_law.h"

namespace demolish {

struct DebrisLaw {
    float spacing = 0;       ///< m, h
    float grit_per_m2 = 0;   ///< of all sizes
    float puffs_per_m2 = 0;  ///< of new face
    float puff_depth = 0;    ///< optical depth through the middle of a new one
    float drag = 0;          ///< of its grains
    float sparks = 0;        ///< share of iron's hard hits
    uint32_t cells = 0;      ///< of the whole body
};

/// Of a puff, in spacings.
inline constexpr double kPuffRadius = 0.6;

/// Many thin puffs or few thick ones give the same dust. What looked right by prototype for five materials
/// (0.06 to 0.35 deep, 0.15 to 2 on h^2) follows from the amount alone, as its power 0.4.
inline double puffDepth(double dust) {
    return 0.35 * std::pow(dust, 0.4);
}

inline DebrisLaw debrisLaw(const BodyInstance& instance, const EffectsSettings& settings) {
    const Material& material = instance.material;
    const double h = instance.body->spacing, millimetre = 1e-3;
    const double radius = kPuffRadius * h, disc = 3.14159265358979 * radius * radius;
    const double dust = settings.dust * material.debris.dust_m2_per_m2;
    DebrisLaw law;
    law.spacing = static_cast<float>(h);
    law.grit_per_m2 = static_cast<float>(settings.grit * material.debris.grit_per_m2 *
                                         std::pow(settings.finest * h / millimetre, -kSizeExponent));
    law.puff_depth = static_cast<float>(puffDepth(dust));
    law.puffs_per_m2 = dust > 0 ? static_cast<float>(dust / (disc * puffDepth(dust))) : 0.0f;
    law.drag = static_cast<float>(dragOf(material.density));
    law.sparks = static_cast<float>(settings.sparks * material.debris.sparks);
    law.cells = static_cast<uint32_t>(instance.body->particles.size());
    return law;
}

inline std::vector<DebrisLaw> debrisLaws(const std::vector<BodyInstance>& bodies,
                                         const EffectsSettings& settings) {
    std::vector<DebrisLaw> laws;
    for (const BodyInstance& instance : bodies) laws.push_back(debrisLaw(instance, settings));
    return laws;
}

/// Sizes in spacings: of grit, of crumbs, and of what is left of a single cell.
struct SizeTables {
    Span<const float> grit, crumbs, rest;
};
inline constexpr double kLeastCrumb = 0.2, kMostCrumb = 0.6, kLeastRest = 0.35;

}  // namespace demolish
