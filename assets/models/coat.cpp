// SPDX-License-Identifier: Apache-2.0
// Ridged value noise, stretched along the hair.
#include "assets/models/coat.h"

#include <algorithm>
#include <cstdint>

namespace demolish::sculptor {
namespace {

double smooth(double t) {
    return t * t * (3 - 2 * t);
}

/// A value in [0, 1) that depends on all bits of a lattice point.
double latticeValue(std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (const std::int64_t coordinate : {x, y, z}) {
        h ^= static_cast<std::uint64_t>(coordinate);
        h *= 0xff51afd7ed558ccdu;
        h ^= h >> 32;
    }
    return static_cast<double>(h >> 11) * 0x1p-53;
}

}  // namespace

double Ramp::at(Vec3 p) const {
    const double c = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    return smooth(std::clamp((c - from) / (to - from), 0.0, 1.0));
}

double valueNoise(Vec3 p) {
    const Vec3 cell{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    const auto x = static_cast<std::int64_t>(cell.x), y = static_cast<std::int64_t>(cell.y),
               z = static_cast<std::int64_t>(cell.z);
    const Vec3 t{smooth(p.x - cell.x), smooth(p.y - cell.y), smooth(p.z - cell.z)};
    const auto mix = [](double a, double b, double s) { return a + s * (b - a); };
    const auto row = [&](int dy, int dz) {
        return mix(latticeValue(x, y + dy, z + dz), latticeValue(x + 1, y + dy, z + dz), t.x);
    };
    return mix(mix(row(0, 0), row(1, 0), t.y), mix(row(0, 1), row(1, 1), t.y), t.z);
}

double coatRelief(const Coat& coat, Vec3 p) {
    const auto region = std::find_if(coat.regions.begin(), coat.regions.end(),
                                     [&](const CoatRegion& r) { return p.z < r.below_z; });
    if (region == coat.regions.end()) return 0;
    double amount = coat.height;
    for (const Ramp& fade : region->fades) amount *= fade.at(p);
    if (amount == 0) return 0;
    double richness = 1;
    for (const auto& richer : coat.richer) richness += richer.gain * richer.ramp.at(p);
    // Two sizes of tufts, four times as long as wide; the fold of the noise at its middle makes the ridges.
    const double w = dot(region->lie, p), u = dot(region->across, p);
    const double noise = 0.65 * valueNoise({p.x / 2.6 + 9, u / 2.6 + 5, w / 9}) +
                         0.35 * valueNoise({p.x / 1.5 + 3, u / 1.5 + 7, w / 6 + 2});
    return amount * richness * (0.55 - 1.6 * std::abs(2 * noise - 1));
}

}  // namespace demolish::sculptor
