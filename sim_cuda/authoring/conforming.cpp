// SPDX-License-Identifier: Apache-2.0
// Feet take two seeds each; pairs slide along their border while all push each other.
#include "sim_cuda/authoring/conforming.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/seed_grid.h"
#include "sim_cuda/authoring/seed_moves.h"

namespace demolish {
namespace {

constexpr int kRounds = 40;
constexpr int kSoftRounds = 8;    // the last ones, in which free seeds are pushed from borders half as much
constexpr int kReleaseEvery = 5;  // rounds, in the second half
// All in spacings.
constexpr double kHalfPair = 0.45;   // of a pair's seed from its border
constexpr double kKeptClear = 0.85;  // of free seeds from a border
constexpr double kHeldAside = 0.8;   // so far round its foot a pair holds the border
constexpr double kCrowded = 0.68;    // pairs with other pairs' seeds nearer than this are let go
constexpr double kShallow = 0.33;    // and those with a seed less deep, if there is room below
constexpr double kRoomBelow = 0.08;
constexpr double kSearch = 1.6;
constexpr uint32_t kNone = 0xffffffffu;

class Conformer {
  public:
    Conformer(const ToughBorders& borders, uint64_t random, std::vector<Double3>& seeds)
        : borders_(borders), random_(random), seeds_(seeds), pair_of_(seeds.size(), kNone) {
        for (const BorderFoot& foot : spreadFeet(borders, seeds, random))
            pairs_.push_back({foot, kNone, kNone});
        takeSeeds();
        numberPairs();
        for (const Pair& pair : pairs_) place(pair, seeds_);
    }

    void round(int number) {
        if (number >= kRounds / 2 && number % kReleaseEvery == 0) release();
        const double firmness = number + kSoftRounds >= kRounds ? 0.5 : 1;
        const SeedCells cells(seeds_, kSearch * borders_.spacing().coarsest());
        const SeedSpacings spacings(borders_.spacing(), seeds_);
        std::vector<Double3> push(seeds_.size()), next(seeds_);
        forEachSeed(seeds_.size(), [&](size_t slot) {
            const uint32_t own = cells.seed(slot), pair = pair_of_[own];
            push[own] = repulsion(cells, slot, spacings, random_,
                                  [&](uint32_t other) { return pair == kNone || pair_of_[other] != pair; });
            if (pair != kNone) return;
            const Double3 out = firmness * outOfBorders(cells, slot);
            next[own] = deepEnough(borders_.grid(), seeds_[own] + push[own] + out, kDepth * spacings[own]);
        });
        forEachSeed(pairs_.size(), [&](size_t k) {
            slide(pairs_[k], 0.5 * (push[pairs_[k].i] + push[pairs_[k].j]));
            place(pairs_[k], next);
        });
        seeds_.swap(next);
    }

  private:
    struct Pair {
        BorderFoot foot;
        uint32_t i, j;  // seeds on a's and on b's side
    };

    /// Each foot the nearest seed that is free, then each a second one: as many seeds as before.
    void takeSeeds() {
        const SeedGrid grid(seeds_, borders_.spacing().coarsest());
        std::vector<uint8_t> taken(seeds_.size(), 0);
        for (uint32_t Pair::*member : {&Pair::i, &Pair::j})
            for (Pair& pair : pairs_) {
                pair.*member = nearestFree(grid, taken, pair.foot.at);
                if (pair.*member != kNone) taken[pair.*member] = 1;
            }
        std::erase_if(pairs_, [](const Pair& pair) { return pair.i == kNone || pair.j == kNone; });
    }

    static uint32_t nearestFree(const SeedGrid& grid, const std::vector<uint8_t>& taken, const Double3& at) {
        const SeedGrid::Place place = grid.placeOf(at);
        double nearest = 1e300;
        uint32_t found = kNone;
        for (int ring = 0; grid.ringDistance(at, place, ring) < std::sqrt(nearest); ++ring)
            grid.visitRing(place, ring, [&](uint32_t seed, const Double3& p) {
                const double squared = lengthSquared(p - at);
                if (taken[seed] || !(squared < nearest || (squared == nearest && seed < found))) return;
                nearest = squared;
                found = seed;
            });
        return found;
    }

    void numberPairs() {
        std::fill(pair_of_.begin(), pair_of_.end(), kNone);
        for (uint32_t k = 0; k < pairs_.size(); ++k) pair_of_[pairs_[k].i] = pair_of_[pairs_[k].j] = k;
    }

    void place(const Pair& pair, std::vector<Double3>& seeds) const {
        const Double3 half = (kHalfPair * borders_.spacingAt(pair.foot.at)) * pair.foot.normal;
        seeds[pair.i] = pair.foot.at + half;
        seeds[pair.j] = pair.foot.at - half;
    }

    /// Along the border, and deeper where it is shallow; stays where that leads to no foot.
    void slide(Pair& pair, const Double3& push) const {
        const BorderFoot& foot = pair.foot;
        const auto along = [&](const Double3& step) { return step - dot(step, foot.normal) * foot.normal; };
        const Double3 pushed = foot.at + along(push);
        const Double3 deep =
            deepEnough(borders_.grid(), pushed, kDepth * borders_.spacingAt(foot.at)) - pushed;
        if (const auto moved = borders_.footNear(pushed + along(deep), foot.a, foot.b)) pair.foot = *moved;
    }

    /// m, of a free seed away from the border that holds it least far off.
    Double3 outOfBorders(const SeedCells& cells, size_t slot) const {
        const Double3 p = cells.position(slot);
        Double3 out;
        cells.visitNear(slot, [&](size_t other) {
            const uint32_t pair = pair_of_[cells.seed(other)];
            if (pair == kNone) return;
            const BorderFoot& foot = pairs_[pair].foot;
            const double h = borders_.spacingAt(foot.at), clear = kKeptClear * h, aside = kHeldAside * h;
            const Double3 from = p - foot.at;
            const double away = dot(from, foot.normal);
            if (std::fabs(away) >= clear || lengthSquared(from) - away * away >= aside * aside) return;
            const Double3 step =
                (0.5 * (away < 0 ? away - -clear : clear - away)) * (away < 0 ? -foot.normal : foot.normal);
            if (lengthSquared(step) > lengthSquared(out)) out = step;
        });
        return out;
    }

    /// Lets go, one after the other, of pairs that crowd others or press a seed against the surface.
    void release() {
        const SeedCells cells(seeds_, kSearch * borders_.spacing().coarsest());
        std::vector<size_t> slot_of(seeds_.size());
        for (size_t slot = 0; slot < slot_of.size(); ++slot) slot_of[cells.seed(slot)] = slot;
        for (uint32_t k = 0; k < pairs_.size(); ++k) {
            Pair& pair = pairs_[k];
            if (!isShallow(pair.i) && !isShallow(pair.j) && !isCrowded(cells, slot_of[pair.i], k) &&
                !isCrowded(cells, slot_of[pair.j], k))
                continue;
            pair_of_[pair.i] = pair_of_[pair.j] = kNone;
            pair.i = kNone;
        }
        std::erase_if(pairs_, [](const Pair& pair) { return pair.i == kNone; });
        numberPairs();
    }
    bool isShallow(uint32_t seed) const {
        const double h = borders_.spacingAt(seeds_[seed]), depth = -borders_.grid().distance(seeds_[seed]);
        if (depth >= kShallow * h) return false;
        const Double3 deep = deeper(borders_.grid(), seeds_[seed], kDepth * h);
        return -borders_.grid().distance(deep) > depth + kRoomBelow * h;
    }
    bool isCrowded(const SeedCells& cells, size_t slot, uint32_t own) const {
        const double least = kCrowded * borders_.spacingAt(cells.position(slot));
        bool crowded = false;
        cells.visitNear(slot, [&](size_t other) {
            const uint32_t pair = pair_of_[cells.seed(other)];
            if (pair == kNone || pair == own) return;
            crowded = crowded || lengthSquared(cells.position(other) - cells.position(slot)) < least * least;
        });
        return crowded;
    }

    const ToughBorders& borders_;
    uint64_t random_;
    std::vector<Double3>& seeds_;
    std::vector<Pair> pairs_;
    std::vector<uint32_t> pair_of_;
};

}  // namespace

void conformSeeds(const ToughBorders& borders, uint64_t random, std::vector<Double3>& seeds,
                  const std::function<void(double fraction)>& tell) {
    Conformer conformer(borders, random, seeds);
    for (int round = 0; round < kRounds; ++round) {
        tell(static_cast<double>(round) / kRounds);
        conformer.round(round);
    }
}

}  // namespace demolish
