// SPDX-License-Identifier: Apache-2.0
// The limits were found on some two hundred files of public collections.
#include "sim_cuda/authoring/repair/sheets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/repair/winding_number.h"

namespace demolish {
namespace {

constexpr double kLargeCaps = 0.4;    // of the part's area
constexpr double kOnlyCaps = 0.9;     // the same: nothing but a rim
constexpr double kFewCaps = 0.05;     // of the part's area: all but closed
constexpr double kRounding = 1e-5;    // volume over area times size, of what is all but closed
constexpr double kSpacings = 1.5;     // thickness of a sheet
constexpr double kProbeOff = 1e-4;    // of the diagonal, from the surface to where its sides are probed
constexpr double kMostOfSize = 0.15;  // thickness over the root of the part's area

/// Of what is all but closed, rounding alone: thin rings and wires are bodies, which thickened walls would
/// turn inside out.
bool isFlatPart(const PartFacts& part) {
    return part.cap_area > kFewCaps * part.area
               ? isFlat(part.volume, part.area, part.diagonal())
               : std::abs(part.volume) < kRounding * part.area * part.diagonal();
}

/// Of caps and of their corners, how much lies inside of the parts that are solid.
struct Shelter {
    double inside = 0, all = 0;  // m^2
    size_t corners_inside = 0, corners = 0;
    void operator+=(const Shelter& other) {
        inside += other.inside, all += other.all;
        corners_inside += other.corners_inside, corners += other.corners;
    }
    bool covers() const {
        return (all > 0 && inside > 0.5 * all) || (corners > 0 && 2 * corners_inside > corners);
    }
};

/// Eyes in their sockets, lids on their pots: what is open is hidden in something solid.
void capSheltered(const RepairMesh& filled, std::vector<PartFacts>& facts, double least_volume) {
    constexpr double kAboutInside = 0.45;  // rims lie on surfaces as often as behind them
    std::vector<char> solid(filled.size());
    for (size_t t = 0; t < filled.size(); ++t) solid[t] = !facts[filled.part[t]].is_sheet;
    const WindingNumber winding(filled.mesh, solid);
    std::vector<size_t> caps;
    for (size_t t = 0; t < filled.size(); ++t)
        if (solid[t] == 0 && filled.source[t] == kNoSource) caps.push_back(t);
    std::vector<Shelter> of_cap(caps.size());
    tbb::parallel_for(size_t(0), caps.size(), [&](size_t i) {
        const size_t t = caps[i];
        of_cap[i] = {0, filled.area(t), 0, 3};
        if (winding.at(filled.middle(t)) > 0.5) of_cap[i].inside = of_cap[i].all;
        for (int k = 0; k < 3; ++k) of_cap[i].corners_inside += winding.at(filled.at(t, k)) > kAboutInside;
    });
    std::vector<Shelter> shelters(facts.size());
    for (size_t i = 0; i < caps.size(); ++i) shelters[filled.part[caps[i]]] += of_cap[i];
    for (size_t p = 0; p < facts.size(); ++p)
        if (facts[p].is_sheet && facts[p].volume > least_volume && shelters[p].covers())
            facts[p].is_sheet = false;
}

/// Of both sides of a triangle, `off` (m) from its middle.
double meanWinding(const WindingNumber& winding, const RepairMesh& mesh, size_t triangle, double off) {
    const Double3 middle = mesh.middle(triangle), side = mesh.normal(triangle) * off;
    return (winding.at(middle + side) + winding.at(middle - side)) / 2;
}

}  // namespace

void findSheets(const RepairMesh& filled, std::vector<PartFacts>& facts) {
    double sheet_area = 0, area = 0;
    size_t sheets = 0;
    for (PartFacts& part : facts) {
        part.is_sheet = !part.is_cavity && (part.cap_area > kLargeCaps * part.area || isFlatPart(part));
        area += part.area;
        if (part.is_sheet) sheet_area += part.area;
    }
    for (PartFacts& part : facts) {
        if (part.is_sheet && sheet_area < 0.5 * area && part.cap_area < kOnlyCaps * part.area &&
            !isFlatPart(part))
            part.is_sheet = false;
        sheets += part.is_sheet;
    }
    const double diagonal = diagonalOf(filled.mesh);
    if (sheets > 0 && sheets < facts.size())
        capSheltered(filled, facts, 1e-7 * diagonal * diagonal * diagonal);
}

std::vector<double> sheetThickness(const std::vector<PartFacts>& facts, double wanted) {
    double volume = 0, area = 0;
    for (const PartFacts& part : facts)
        (part.is_sheet ? area : volume) += part.is_sheet ? part.area : part.volume;
    // N h^3 = V + 1.5 h A by Newton's method from above the root
    volume = std::max(0.0, volume);
    double spacing = std::cbrt(volume / kSheetParticles) + std::sqrt(kSpacings * area / kSheetParticles);
    for (int round = 0; round < 60 && area > 0; ++round) {
        const double value =
                         kSheetParticles * spacing * spacing * spacing - kSpacings * area * spacing - volume,
                     slope = 3 * kSheetParticles * spacing * spacing - kSpacings * area;
        spacing -= value / slope;
    }
    std::vector<double> thickness(facts.size(), 0);
    for (size_t p = 0; p < facts.size(); ++p)
        if (facts[p].is_sheet)
            thickness[p] =
                wanted > 0 ? wanted : std::min(kSpacings * spacing, kMostOfSize * std::sqrt(facts[p].area));
    return thickness;
}

bool sheetsEncloseSolid(const RepairMesh& filled, const std::vector<PartFacts>& facts) {
    constexpr size_t kProbes = 3000;
    constexpr double kLeastOfOthers = 0.15;  // of the mean winding number: what the other parts bring
    std::vector<char> of_file(filled.size());
    std::vector<std::vector<size_t>> walls(facts.size());
    for (size_t t = 0; t < filled.size(); ++t) {
        of_file[t] = filled.source[t] != kNoSource;
        if (of_file[t] == 0 || !facts[filled.part[t]].is_sheet) continue;
        walls[filled.part[t]].push_back(t);
    }
    // Every so many of all, whichever parts they are of: many parts have few walls each.
    std::vector<size_t> before(facts.size() + 1, 0);
    for (size_t p = 0; p < facts.size(); ++p) before[p + 1] = before[p] + walls[p].size();
    const WindingNumber winding(filled.mesh, of_file);
    const size_t step = std::max<size_t>(1, before.back() / kProbes);
    const double off = kProbeOff * diagonalOf(filled.mesh);
    std::vector<double> wall_area(facts.size(), 0), area(facts.size(), 0);
    tbb::parallel_for(size_t(0), facts.size(), [&](size_t p) {
        const size_t first = (before[p] + step - 1) / step * step - before[p];
        if (first >= walls[p].size()) return;
        std::vector<Triangle> own_triangles;
        for (const size_t t : walls[p]) own_triangles.push_back(filled.mesh.triangles[t]);
        const WindingNumber own(filled.mesh.positions, own_triangles);
        for (size_t i = first; i < walls[p].size(); i += step) {
            const size_t t = walls[p][i];
            const double mean = meanWinding(winding, filled, t, off),
                         alone = meanWinding(own, filled, t, off);
            area[p] += filled.area(t);
            if (mean > 0.3 && mean < 0.7 && mean - alone > kLeastOfOthers) wall_area[p] += filled.area(t);
        }
    });
    const double all_walls = std::accumulate(wall_area.begin(), wall_area.end(), 0.0);
    return all_walls > 0 && all_walls > 0.5 * std::accumulate(area.begin(), area.end(), 0.0);
}

}  // namespace demolish
