// SPDX-License-Identifier: Apache-2.0
// Profiles of vessels.
#include "assets/models/lathe.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "assets/models/curve.h"
#include "assets/models/revolve.h"

namespace demolish::sculptor {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Rings from the outer bottom pole (not among them) over the rim to the inner bottom pole (neither), every
/// interval of the recipe divided into `m`.
std::vector<Ring> vesselRings(const VesselRecipe& recipe, int m) {
    const Curve radius(recipe.fractions, recipe.radii);
    std::vector<Ring> rings;
    const double foot = radius.at(recipe.outer_rings.front());
    for (int i = 1; i < m; ++i) rings.push_back({foot * i / m, recipe.outer_rings.front() * recipe.height});
    const auto alongWall = [&](const std::vector<double>& fractions, double inset) {
        for (std::size_t f = 0; f + 1 < fractions.size(); ++f)
            for (int i = 0; i < m; ++i) {
                const double fraction = fractions[f] + (fractions[f + 1] - fractions[f]) * i / m;
                rings.push_back({radius.at(fraction) - inset, fraction * recipe.height});
            }
        rings.push_back({radius.at(fractions.back()) - inset, fractions.back() * recipe.height});
    };
    alongWall(recipe.outer_rings, 0);
    // The rim is half an ellipse; at m = 1 only its top is a ring.
    const double half = recipe.wall / 2, middle = rings.back().radius - half, top = rings.back().y;
    for (int i = 1; i < 2 * m; ++i) {
        const double angle = kPi * i / (2 * m);
        rings.push_back({middle + half * std::cos(angle), top + recipe.rim_rise * std::sin(angle)});
    }
    alongWall(recipe.inner_rings, recipe.wall);
    const Ring bowl = rings.back();
    for (int i = 1; i < m; ++i) {
        const double angle = kPi / 2 * i / m;
        rings.push_back({bowl.radius * std::cos(angle),
                         recipe.inner_bottom + (bowl.y - recipe.inner_bottom) * (1 - std::sin(angle))});
    }
    return rings;
}

TurnedRing roundRing(const Ring& ring, int sectors) {
    TurnedRing turned{ring.radius, ring.y, {}};
    for (int s = 0; s < sectors; ++s) {
        const double angle = 2 * kPi * s / sectors, c = std::cos(angle), sn = std::sin(angle);
        turned.points.push_back({ring.radius * c, ring.y, ring.radius * sn});
    }
    return turned;
}

}  // namespace

Turned turnVessel(const VesselRecipe& recipe, std::size_t triangles) {
    constexpr int kFinest = 32;
    const std::size_t own_rings = recipe.outer_rings.size() + 1 + recipe.inner_rings.size();
    const auto ringsAt = [&](int m) { return m * (own_rings + 1) - 1; };
    int best = 0;
    double best_stretch = 1.6;  // sectors may be up to this much more or fewer than the division asks for
    std::string nearest;
    for (int m = 1; m <= kFinest; ++m) {
        const double wanted = double(m) * recipe.sectors;
        if (m <= 4) nearest += (m > 1 ? ", " : "") + std::to_string(2 * m * recipe.sectors * ringsAt(m));
        if (triangles % (4 * ringsAt(m)) != 0) continue;
        const double sectors = static_cast<double>(triangles / (2 * ringsAt(m)));
        const double stretch = std::max(sectors / wanted, wanted / sectors);
        if (stretch < best_stretch) best = m, best_stretch = stretch;
    }
    if (best == 0)
        throw std::runtime_error("no division of the rings gives this count; the even ones give " + nearest);
    const int sectors = static_cast<int>(triangles / (2 * ringsAt(best)));
    std::vector<TurnedRing> rings;
    for (const Ring& ring : vesselRings(recipe, best)) rings.push_back(roundRing(ring, sectors));
    return revolve(rings, recipe.inner_bottom);
}

}  // namespace demolish::sculptor
