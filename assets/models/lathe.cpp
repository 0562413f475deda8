// Profiles of turned bodies and the triangles between their rings.
#include "assets/models/lathe.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace demolish::sculptor {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Cubic Hermite curve through (x, y) with the slopes of the parabola through each point and its neighbours.
class Curve {
  public:
    Curve(const std::vector<double>& x, const std::vector<double>& y) : x_(x), y_(y), slope_(x.size()) {
        const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
        const std::size_t last = x.size() - 1;
        for (std::size_t i = 1; i < last; ++i) {
            const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
            slope_[i] = (after * secant(i - 1) + before * secant(i)) / (before + after);
        }
        slope_[0] = 2 * secant(0) - slope_[1];
        slope_[last] = 2 * secant(last - 1) - slope_[last - 1];
    }

    double at(double x) const {
        const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
        const std::size_t i = static_cast<std::size_t>(above - x_.begin()) - 1;
        const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h, u = 1 - t;
        return u * u * ((1 + 2 * t) * y_[i] + t * h * slope_[i]) +
               t * t * ((1 + 2 * u) * y_[i + 1] - u * h * slope_[i + 1]);
    }

  private:
    std::vector<double> x_, y_, slope_;
};

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

Vec3 ringPoint(const Ring& ring, int s, int sectors) {
    const double angle = 2 * kPi * s / sectors, c = std::cos(angle), sn = std::sin(angle);
    double radius = ring.radius;
    if (ring.shape == RingShape::kSquare) radius /= std::max(std::abs(c), std::abs(sn));
    if (ring.shape == RingShape::kFluted && s % 2 == 1) radius *= 0.86;
    return {radius * c, ring.y, radius * sn};
}

/// Distance along the profile from the first pole to each ring and the last pole, the whole being 1.
std::vector<double> profileDistances(const std::vector<Ring>& rings, double last_pole) {
    std::vector<double> distances;
    double sum = 0, r = 0, y = rings.front().y;
    const auto walkTo = [&](double next_r, double next_y) {
        sum += std::hypot(next_r - r, next_y - y);
        distances.push_back(sum);
        r = next_r, y = next_y;
    };
    for (const Ring& ring : rings) walkTo(ring.radius, ring.y);
    walkTo(0, last_pole);
    for (double& d : distances) d /= sum;
    return distances;
}

/// Vertices: first pole, rings, last pole. The first pole lies in the plane of the first ring.
Turned revolve(const std::vector<Ring>& rings, double last_pole, int sectors) {
    Turned turned;
    const auto v = profileDistances(rings, last_pole);
    const int count = static_cast<int>(rings.size());
    auto& positions = turned.surface.positions;
    positions.push_back({0, rings.front().y, 0});
    for (const Ring& ring : rings)
        for (int s = 0; s < sectors; ++s) positions.push_back(ringPoint(ring, s, sectors));
    positions.push_back({0, last_pole, 0});
    using Corner = std::pair<std::uint32_t, std::array<double, 2>>;
    const auto corner = [&](int ring, int s) -> Corner {
        if (ring < 0) return {0, {0.5, 0}};
        if (ring == count) return {static_cast<std::uint32_t>(positions.size() - 1), {0.5, 1}};
        return {1 + static_cast<std::uint32_t>(ring * sectors + s % sectors), {double(s) / sectors, v[ring]}};
    };
    const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
        turned.surface.triangles.push_back({a.first, b.first, c.first});
        turned.uvs.push_back({a.second, b.second, c.second});
    };
    for (int ring = -1; ring < count; ++ring)
        for (int s = 0; s < sectors; ++s) {
            if (ring >= 0) add(corner(ring, s), corner(ring + 1, s), corner(ring, s + 1));
            if (ring + 1 < count) add(corner(ring, s + 1), corner(ring + 1, s), corner(ring + 1, s + 1));
        }
    return turned;
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
    return revolve(vesselRings(recipe, best), recipe.inner_bottom, sectors);
}

Turned turnColumn(const ColumnRecipe& recipe, std::size_t triangles) {
    const std::size_t own = 2 * recipe.rings.size() * recipe.sectors;
    const std::size_t most = own + 2 * static_cast<std::size_t>(recipe.sectors);
    if (triangles < own || triangles > most || triangles % 2 != 0)
        throw std::runtime_error("this column has " + std::to_string(own) + " to " + std::to_string(most) +
                                 " triangles, an even number");
    Turned turned = revolve(recipe.rings, recipe.rings.back().y, recipe.sectors);
    for (std::size_t i = 0; i < (triangles - own) / 2; ++i) splitTriangle(turned, i);
    return turned;
}

}  // namespace demolish::sculptor
