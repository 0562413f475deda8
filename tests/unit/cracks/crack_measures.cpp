// SPDX-License-Identifier: Apache-2.0
// Reads lines, faces and parts off what is drawn.
#include "tests/unit/cracks/crack_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sim_cuda/authoring/double3.h"

namespace demolish::test {
namespace {

constexpr double kFit = 1.5;  ///< h, sigma of the quadratic fit

Double3 asDouble(const Float3& p) {
    return {p.x, p.y, p.z};
}

struct Facet {
    Double3 centre, normal;  ///< normal: from the lower fragment to the higher
    double area;
};
using Faces = std::map<std::pair<uint32_t, uint32_t>, std::vector<Facet>>;

Faces largeFaces(DrawnSurface& drawn, const std::vector<uint32_t>& size) {
    const FractureGeometry& geometry = drawn.scene.geometry;
    const std::vector<Float3> pool = drawn.positions();
    Faces faces;
    for (const InteriorFace& face : geometry.faces) {
        const uint32_t a = drawn.fragments[face.cell_a], b = drawn.fragments[face.cell_b];
        if (a == b || std::min(size[a], size[b]) < kLargePiece) continue;
        for (uint32_t i = face.first_index; i < face.first_index + face.index_count; i += 3) {
            const auto at = [&](uint32_t k) {
                return asDouble(
                    pool[geometry.face_vertices[face.first_vertex + geometry.face_indices[i + k]]]);
            };
            const Double3 turn = cross(at(1) - at(0), at(2) - at(0)) * (a < b ? 0.5 : -0.5);
            faces[std::minmax(a, b)].push_back(
                {(at(0) + at(1) + at(2)) * (1.0 / 3), normalized(turn), length(turn)});
        }
    }
    return faces;
}

/// Solves by elimination; the matrix is symmetric and positive.
double constantOfFit(std::array<std::array<double, 7>, 6>& m) {
    for (size_t k = 0; k < 6; ++k) {
        if (m[k][k] < 1e-14) return 0;
        for (size_t r = 0; r < 6; ++r) {
            if (r == k) continue;
            const double share = m[r][k] / m[k][k];
            for (size_t c = k; c < 7; ++c) m[r][c] -= share * m[k][c];
        }
    }
    return m[0][6] / m[0][0];
}

/// h, how far a facet lies from the quadratic through those round it.
double offFit(const Facet& own, const std::vector<Facet>& facets, double h) {
    const double reach = 2.5 * kFit * h;
    Double3 mean;
    for (const Facet& other : facets)
        if (lengthSquared(other.centre - own.centre) < reach * reach) mean += other.normal * other.area;
    const Double3 up = normalized(mean);
    const Double3 u = normalized(cross(up, std::fabs(up.x) < 0.7 ? Double3{1, 0, 0} : Double3{0, 1, 0}));
    const Double3 v = cross(up, u);
    std::array<std::array<double, 7>, 6> m{};
    for (const Facet& other : facets) {
        const Double3 to = other.centre - own.centre;
        if (lengthSquared(to) >= reach * reach) continue;
        const double x = dot(to, u) / h, y = dot(to, v) / h, z = dot(to, up) / h;
        const double weight = other.area * std::exp(-0.5 * lengthSquared(to) / (kFit * h * kFit * h));
        const std::array<double, 7> row{1, x, y, x * x, x * y, y * y, z};
        for (size_t r = 0; r < 6; ++r)
            for (size_t c = 0; c < 7; ++c) m[r][c] += weight * row[r] * row[c];
    }
    return constantOfFit(m);
}

void measureFaces(const Faces& faces, double h, CrackMeasures& measures) {
    double squares = 0, area = 0;
    for (const auto& [pair, facets] : faces) {
        double whole = 0;
        for (const Facet& facet : facets) whole += facet.area;
        if (whole < 12 * h * h) continue;
        for (const Facet& facet : facets) {
            const double off = offFit(facet, facets, h);
            squares += facet.area * off * off;
            area += facet.area;
        }
    }
    measures.faces = area > 0 ? std::sqrt(squares / area) : 0;
    measures.face_area = area / (h * h);
}

void measureParts(const DrawnSurface& drawn, double h, CrackMeasures& measures) {
    const FractureGeometry& geometry = drawn.scene.geometry;
    double area = 0, flipped = 0;
    for (size_t i = 0; i < geometry.exterior_indices.size(); i += 3) {
        const auto normal = [&](const std::vector<SurfaceVertex>& from) {
            const auto at = [&](size_t k) {
                return asDouble(from[geometry.exterior_indices[i + k]].position);
            };
            return cross(at(1) - at(0), at(2) - at(0));
        };
        const Double3 rest = normal(geometry.exterior), now = normal(drawn.outside);
        area += length(rest) / 2;
        ++measures.parts;
        if (length(rest) < 2e-6 * h * h || dot(rest, now) >= 0) continue;  // what has no area has no side
        ++measures.flipped;
        flipped += length(now) / 2;
    }
    measures.flipped_area = flipped / area;
}

}  // namespace

CrackMeasures measureCracks(DrawnSurface& drawn, double h, double volume) {
    CrackMeasures measures;
    std::vector<uint32_t> size(drawn.fragments.size(), 0);
    for (const uint32_t slot : drawn.fragments) ++size[slot];
    for (const uint32_t cells : size) {
        measures.pieces += cells > 0 ? 1 : 0;
        measures.large_pieces += cells >= kLargePiece ? 1 : 0;
    }
    const FractureGeometry& geometry = drawn.scene.geometry;
    const auto outline = [&](const std::vector<SurfaceVertex>& outside) {
        return measureLines(crackOutlines(geometry, outside, drawn.fragments, size), h);
    };
    measures.outline = outline(drawn.outside);
    measures.outline_at_rest = outline(geometry.exterior);
    measureFaces(largeFaces(drawn, size), h, measures);
    measureParts(drawn, h, measures);
    double sum = 0;
    for (const Soup& soup : drawn.soups(static_cast<uint32_t>(size.size()))) {
        measures.open_edges += openEdges(soup);
        sum += enclosedVolume(soup);
    }
    measures.volume_error = std::fabs(sum / volume - 1);
    return measures;
}

}  // namespace demolish::test
