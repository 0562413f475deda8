// SPDX-License-Identifier: Apache-2.0
// Columns: the recipe's own rings, or more of them along the same mouldings and flutes.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "assets/models/curve.h"
#include "assets/models/revolve.h"

namespace demolish::sculptor {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFluteDepth = 0.14;  // of the radius

/// Radius of a ring's outline at an angle, as a share of the ring's own. A flute spans two of the recipe's
/// sectors and is deepest in its middle; its edges are sharp.
double outline(RingShape shape, double angle, int recipe_sectors) {
    if (shape == RingShape::kSquare)
        return 1 / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
    if (shape == RingShape::kRound) return 1;
    const double flutes = angle / (2 * kPi) * recipe_sectors / 2,
                 across = 2 * (flutes - std::floor(flutes)) - 1;
    return 1 - kFluteDepth * (1 - across * across);
}

/// A ring of the recipe as it is: every second vertex of a fluted one is drawn in.
TurnedRing ownRing(const Ring& ring, int sectors) {
    TurnedRing turned{ring.radius, ring.y, {}};
    for (int s = 0; s < sectors; ++s) {
        const double angle = 2 * kPi * s / sectors, c = std::cos(angle), sn = std::sin(angle);
        double radius = ring.radius;
        if (ring.shape == RingShape::kSquare) radius /= std::max(std::abs(c), std::abs(sn));
        if (ring.shape == RingShape::kFluted && s % 2 == 1) radius *= 1 - kFluteDepth;
        turned.points.push_back({radius * c, ring.y, radius * sn});
    }
    return turned;
}

/// Radius over height between the recipe's rings: a smooth curve along three or more rings of one shape that
/// rise, straight lines elsewhere.
class Profile {
  public:
    explicit Profile(const std::vector<Ring>& rings) : rings_(rings) {
        for (std::size_t first = 0; first < rings.size();) {
            std::size_t last = first;
            while (last + 1 < rings.size() && rings[last + 1].shape == rings[first].shape &&
                   rings[last + 1].y > rings[last].y)
                ++last;
            if (last - first >= 2) addCurve(first, last);
            first = last + 1;
        }
    }

    /// At the share `t` of the way from ring `i` to the next.
    Ring at(std::size_t i, double t) const {
        const Ring &a = rings_[i], &b = rings_[i + 1];
        const double y = a.y + (b.y - a.y) * t;
        for (const Run& run : runs_)
            if (i >= run.first && i < run.last) return {run.curve.at(y), y, a.shape};
        return {a.radius + (b.radius - a.radius) * t, y, a.shape};
    }

  private:
    struct Run {
        std::size_t first, last;
        Curve curve;
    };
    void addCurve(std::size_t first, std::size_t last) {
        std::vector<double> y, radius;
        for (std::size_t i = first; i <= last; ++i)
            y.push_back(rings_[i].y), radius.push_back(rings_[i].radius);
        runs_.push_back({first, last, Curve(y, radius)});
    }

    const std::vector<Ring>& rings_;
    std::vector<Run> runs_;
};

/// Lengths along the profile: bottom cap, between the rings, top cap.
std::vector<double> intervalLengths(const std::vector<Ring>& rings) {
    std::vector<double> lengths{rings.front().radius};
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
        lengths.push_back(std::hypot(rings[i + 1].radius - rings[i].radius, rings[i + 1].y - rings[i].y));
    lengths.push_back(rings.back().radius);
    return lengths;
}

/// Deals `parts` out so that the longest part gets as short as can be; every interval gets one at least.
std::vector<int> dividedBy(const std::vector<double>& lengths, std::size_t parts) {
    std::vector<int> divisions(lengths.size(), 1);
    for (std::size_t dealt = lengths.size(); dealt < parts; ++dealt) {
        std::size_t longest = 0;
        for (std::size_t i = 1; i < lengths.size(); ++i)
            if (lengths[i] / divisions[i] > lengths[longest] / divisions[longest]) longest = i;
        ++divisions[longest];
    }
    return divisions;
}

TurnedRing fineRing(const Ring& ring, RingShape next_shape, double t, int sectors, int recipe_sectors) {
    TurnedRing turned{ring.radius, ring.y, {}};
    for (int s = 0; s < sectors; ++s) {
        const double angle = 2 * kPi * s / sectors;
        const double radius = ring.radius * ((1 - t) * outline(ring.shape, angle, recipe_sectors) +
                                             t * outline(next_shape, angle, recipe_sectors));
        turned.points.push_back({radius * std::cos(angle), ring.y, radius * std::sin(angle)});
    }
    return turned;
}

Turned turnFine(const ColumnRecipe& recipe, int sectors, std::size_t count) {
    const std::vector<int> divisions = dividedBy(intervalLengths(recipe.rings), count + 1);
    const Profile profile(recipe.rings);
    std::vector<TurnedRing> rings;
    const auto add = [&](const Ring& ring, RingShape next, double t) {
        rings.push_back(fineRing(ring, next, t, sectors, recipe.sectors));
    };
    const Ring &foot = recipe.rings.front(), &top = recipe.rings.back();
    for (int k = 1; k < divisions.front(); ++k)
        add({foot.radius * k / divisions.front(), foot.y, foot.shape}, foot.shape, 0);
    for (std::size_t i = 0; i + 1 < recipe.rings.size(); ++i)
        for (int k = 0; k < divisions[i + 1]; ++k) {
            const double t = double(k) / divisions[i + 1];
            add(profile.at(i, t), recipe.rings[i + 1].shape, t);
        }
    for (int k = divisions.back(); k > 0; --k)
        add({top.radius * k / divisions.back(), top.y, top.shape}, top.shape, 0);
    return revolve(rings, top.y);
}

/// Cuts triangle `index` into three around its centre.
void splitTriangle(Turned& turned, std::size_t index) {
    auto& [positions, triangles] = turned.surface;
    const Triangle t = triangles[index];
    const auto uv = turned.uvs[index];
    const auto centre = static_cast<std::uint32_t>(positions.size());
    positions.push_back((1.0 / 3) * (positions[t[0]] + positions[t[1]] + positions[t[2]]));
    const std::array<double, 2> middle = {(uv[0][0] + uv[1][0] + uv[2][0]) / 3,
                                          (uv[0][1] + uv[1][1] + uv[2][1]) / 3};
    triangles[index] = {t[0], t[1], centre};
    turned.uvs[index] = {uv[0], uv[1], middle};
    for (int i = 1; i < 3; ++i) {
        triangles.push_back({t[i], t[(i + 1) % 3], centre});
        turned.uvs.push_back({uv[i], uv[(i + 1) % 3], middle});
    }
}

/// How often the sectors are divided so that the triangles along the shaft are about twice as high as wide:
/// it is round about and nearly straight upwards. 0 when the count cannot be reached.
int fineDivision(const ColumnRecipe& recipe, std::size_t triangles) {
    constexpr double kWantedShape = 2;
    constexpr int kFinest = 32;
    double length = 0, radius = 0;
    for (const double part : intervalLengths(recipe.rings)) length += part;
    for (const Ring& ring : recipe.rings) radius += ring.radius / static_cast<double>(recipe.rings.size());
    int best = 0;
    double best_stretch = 0;
    for (int m = 2; m <= kFinest; ++m) {
        const std::size_t sectors = static_cast<std::size_t>(recipe.sectors) * m;
        const std::size_t rings = triangles / (2 * sectors);
        if (triangles % (2 * sectors) != 0 || rings < recipe.rings.size() + 1) continue;
        const double shape =
            length / static_cast<double>(rings + 1) / (2 * kPi * radius / static_cast<double>(sectors));
        const double stretch = std::max(shape / kWantedShape, kWantedShape / shape);
        if (best == 0 || stretch < best_stretch) best = m, best_stretch = stretch;
    }
    return best;
}

}  // namespace

bool isDivided(const ColumnRecipe& recipe, std::size_t triangles) {
    return triangles > 2 * (recipe.rings.size() + 1) * static_cast<std::size_t>(recipe.sectors);
}

Turned turnColumn(const ColumnRecipe& recipe, std::size_t triangles) {
    const std::size_t sectors = static_cast<std::size_t>(recipe.sectors),
                      own = 2 * recipe.rings.size() * sectors;
    if (isDivided(recipe, triangles)) {
        const int division = fineDivision(recipe, triangles);
        if (division > 0)
            return turnFine(recipe, recipe.sectors * division, triangles / (2 * sectors * division));
    }
    if (triangles < own || isDivided(recipe, triangles) || triangles % 2 != 0)
        throw std::runtime_error(
            "this column has " + std::to_string(own) + " to " + std::to_string(own + 2 * sectors) +
            " triangles, an even number, or a multiple of " + std::to_string(4 * sectors) + " from " +
            std::to_string(4 * sectors * (recipe.rings.size() + 1)) + " on");
    std::vector<TurnedRing> rings;
    for (const Ring& ring : recipe.rings) rings.push_back(ownRing(ring, recipe.sectors));
    Turned turned = revolve(rings, recipe.rings.back().y);
    for (std::size_t i = 0; i < (triangles - own) / 2; ++i) splitTriangle(turned, i);
    return turned;
}

}  // namespace demolish::sculptor
