// SPDX-License-Identifier: Apache-2.0
// From outcomes to probabilities: counts by size and velocity, Wilson intervals, the paper's stated numbers.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "app/breakage/item_file.h"

namespace demolish {

struct Interval {
    double low = 0, high = 1;
};
/// Wilson's score interval of a probability after `hits` of `trials`, 95 % by default (Wilson 1927); 0..1 for
/// no trials.
Interval wilsonInterval(uint32_t hits, uint32_t trials, double z = 1.959963984540054);

inline constexpr uint32_t kMostChildren = 7;  ///< counted apart; the last column holds more as well

/// All packings of one size at one velocity.
struct BreakageCell {
    uint32_t specimens = 0, broken = 0;  ///< by the experiment's rule
    uint32_t split = 0, meridional = 0, both = 0;
    std::array<uint32_t, kMostChildren + 1> children{};  ///< of the broken ones, how many have k children
    uint32_t children_in_all = 0;                        ///< of the broken ones

    uint32_t threeToFive() const { return children[3] + children[4] + children[5]; }
    double probability() const { return specimens > 0 ? double(broken) / specimens : 0; }
    double meanChildren() const { return broken > 0 ? double(children_in_all) / broken : 0; }
    /// Share of the specimens that both rules judge alike.
    double agreement() const {
        return specimens > 0 ? 1 - double(split + meridional - 2 * both) / specimens : 1;
    }
};

struct BreakageStatistics {
    std::vector<double> velocities;                                        ///< m/s
    std::array<std::vector<BreakageCell>, 2> cells;                        ///< by size, then velocity
    double kinetic = 0, damping = 0, friction = 0, fracture = 0, sum = 0;  ///< over the impact energy
    double time_step = 0;                                                  ///< s
    uint64_t particles = 0, substeps = 0;                                  ///< of all items; of the longest
};

/// One for each of the plan's experiments; `results` in the order of the items.
std::vector<BreakageStatistics> summarise(const BreakagePlan& plan, std::span<const ItemResult> results);

/// Linear between velocities, the end values beyond.
double probabilityAt(const BreakageStatistics& statistics, uint32_t size, double velocity);
/// m/s: lowest velocity from which on, by straight lines, the probability is `p`; NaN if it is never reached.
double velocityAt(const BreakageStatistics& statistics, uint32_t size, double p);

/// What the paper's text says of Figs 1 and 2.
struct StatedPoint {
    uint32_t size;               ///< 0: 24 um, 1: 36 um
    double velocity;             ///< m/s
    double probability;          ///< 13 and 16 of 30 at 43 m/s
    bool with_figure_2 = false;  ///< the paper gives it there
};
inline constexpr std::array<StatedPoint, 4> kStated{
    {{0, 35, 0.0}, {0, 45, 1.0}, {0, 43, 13.0 / 30, true}, {1, 43, 16.0 / 30, true}}};
/// Root mean square of the differences to kStated.
double distanceToPaper(const BreakageStatistics& statistics);

/// Of all specimens, those broken into 3 to 5 children: what the paper's Fig 2 counts. Linear between
/// velocities.
double countedAt(const BreakageStatistics& statistics, uint32_t size, double velocity);
/// As distanceToPaper, where 13 and 16 of 30, which the paper gives with Fig 2, are counted as Fig 2 counts.
double distanceCounted(const BreakageStatistics& statistics);

/// Of all broken specimens of a size: the share with 3 to 5 children.
double shareOfThreeToFive(const BreakageStatistics& statistics, uint32_t size);

}  // namespace demolish
