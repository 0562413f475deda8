// SPDX-License-Identifier: Apache-2.0
// Candidates between seeds of different tough cells, thinned out by darts.
#include "sim_cuda/authoring/border_feet.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/seed_grid.h"
#include "sim_cuda/authoring/seed_moves.h"

namespace demolish {
namespace {

constexpr uint64_t kFootStream = 91, kRankStream = 92;
// All in spacings.
constexpr double kSearch = 1.6;      // so near are the two seeds that a candidate lies between
constexpr double kApart = 0.85;      // between feet
constexpr double kClear = 0.3;       // to a third cell
constexpr double kFootDepth = 0.05;  // below the surface
constexpr double kGradient = 0.05;   // reach of differences
constexpr double kJitter = 1.0;      // edge of the cube round the middle of two seeds
constexpr uint64_t kCopies = 3;      // jittered candidates for each two seeds, the first is not
constexpr int kProjections = 3;

struct Candidate {
    BorderFoot foot;
    double rank;  // the lower goes first
};

void candidatesOf(const ToughBorders& borders, const SeedCells& cells, size_t slot,
                  const std::vector<uint32_t>& label, uint64_t random, std::vector<Candidate>& found) {
    const uint32_t own = cells.seed(slot);
    const Double3 p = cells.position(slot);
    cells.visitNear(slot, [&](size_t other) {
        const uint32_t beside = cells.seed(other);
        const Double3 middle = 0.5 * (p + cells.position(other));
        const double h = borders.spacingAt(middle);
        if (beside < own || label[own] == label[beside] ||
            lengthSquared(cells.position(other) - p) > kSearch * kSearch * h * h)
            return;
        const uint64_t pair = counterHash(own, beside);
        for (uint64_t copy = 0; copy < kCopies; ++copy) {
            const Double3 jitter =
                copy == 0 ? Double3{} : hashRandomInCube(random, kFootStream, kCopies * pair + copy);
            const auto foot = borders.footNear(middle + (kJitter * h) * jitter, label[own], label[beside]);
            if (foot)
                found.push_back(
                    {*foot, (copy == 0 ? 0 : 1) + hashRandom(random, kRankStream, kCopies * pair + copy)});
        }
    });
}

std::vector<Candidate> allCandidates(const ToughBorders& borders, const std::vector<Double3>& seeds,
                                     uint64_t random) {
    const SeedCells cells(seeds, kSearch * borders.spacing().coarsest());
    std::vector<uint32_t> label(seeds.size());
    forEachSeed(seeds.size(), [&](size_t i) { label[i] = borders.field().cellAt(seeds[i]); });
    std::vector<std::vector<Candidate>> of_slot(seeds.size());
    forEachSeed(seeds.size(),
                [&](size_t slot) { candidatesOf(borders, cells, slot, label, random, of_slot[slot]); });
    std::vector<Candidate> all;
    for (const auto& some : of_slot) all.insert(all.end(), some.begin(), some.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.rank < b.rank; });
    return all;
}

}  // namespace

std::optional<BorderFoot> ToughBorders::footNear(const Double3& x, uint32_t a, uint32_t b) const {
    const double h = spacingAt(x);
    BorderFoot foot{x, a, b, {}};
    for (int k = 0; k <= kProjections; ++k) {
        const Double3 gradient = borderGradient(field_, foot.at, a, b, kGradient * h);
        const double steep = lengthSquared(gradient);
        if (!(steep > 0)) return std::nullopt;
        foot.normal = normalized(gradient);
        if (k < kProjections) foot.at += gradient * (-field_.side(foot.at, a, b) / steep);
    }
    if (-grid_.distance(foot.at) < kFootDepth * h || !isClear(foot)) return std::nullopt;
    return foot;
}

/// All round the foot and on its both sides there is no third cell.
bool ToughBorders::isClear(const BorderFoot& foot) const {
    const double reach = kClear * spacingAt(foot.at);
    const Double3 aside = std::fabs(foot.normal.x) < 0.7 ? Double3{1, 0, 0} : Double3{0, 1, 0};
    const Double3 u = normalized(cross(foot.normal, aside)), v = cross(foot.normal, u);
    const auto isOneOfBoth = [&](const Double3& step) {
        const uint32_t cell = field_.cellAt(foot.at + reach * step);
        return cell == foot.a || cell == foot.b;
    };
    return isOneOfBoth(u) && isOneOfBoth(-u) && isOneOfBoth(v) && isOneOfBoth(-v) &&
           field_.cellAt(foot.at + reach * foot.normal) == foot.a &&
           field_.cellAt(foot.at - reach * foot.normal) == foot.b;
}

std::vector<BorderFoot> spreadFeet(const ToughBorders& borders, const std::vector<Double3>& seeds,
                                   uint64_t random) {
    const std::vector<Candidate> candidates = allCandidates(borders, seeds, random);
    if (candidates.empty()) return {};
    std::vector<Double3> places;
    for (const Candidate& candidate : candidates) places.push_back(candidate.foot.at);
    const SeedGrid grid(places, kApart * borders.spacing().coarsest());
    std::vector<uint8_t> taken(places.size(), 0);
    std::vector<BorderFoot> feet;
    for (size_t c = 0; c < places.size(); ++c) {
        const SeedGrid::Place at = grid.placeOf(places[c]);
        const double apart = kApart * borders.spacingAt(places[c]);
        bool is_free = true;
        for (int ring = 0; ring <= 1; ++ring)
            grid.visitRing(at, ring, [&](uint32_t other, const Double3& place) {
                is_free = is_free && !(taken[other] && lengthSquared(place - places[c]) < apart * apart);
            });
        if (!is_free) continue;
        taken[c] = 1;
        feet.push_back(candidates[c].foot);
    }
    return feet;
}

}  // namespace demolish
