// SPDX-License-Identifier: Apache-2.0
// What an impact made of one specimen: child fragments, and whether it counts as broken by either rule.
#pragma once
#include <cstdint>
#include <span>

#include "sim_cuda/api/breakable_body.h"

namespace demolish {

/// When a specimen counts as broken.
enum class BreakRule {
    kLargest,     ///< the largest fragment has less than Criteria::intact_share of the volume
    kMeridional,  ///< a crack runs through the whole specimen along the line of impact (the paper's words)
    kFlaps,       ///< at least Criteria::flaps children: the paper's Fig 2 counts "between 3 and 5"
};

struct Criteria {
    double child_share = 0.03;   ///< of the specimen's volume: smaller fragments are not counted (paper 4.1)
    double intact_share = 0.80;  ///< of the volume
    uint32_t flaps = 3;
    uint32_t slabs = 6;  ///< a crack goes through when it is seen in each of these slices of the height
};

struct Outcome {
    double largest = 1;       ///< share of the volume
    uint32_t children = 1;    ///< fragments of at least child_share
    bool split = false;       ///< BreakRule::kLargest
    bool meridional = false;  ///< BreakRule::kMeridional
};

bool isBroken(const Outcome& outcome, BreakRule rule, const Criteria& criteria);

/// `fragment`: a number for every particle, equal within a fragment. The line of impact is the body's y axis.
///
/// Meridional: crumbs go to the child that they were bonded to, through other crumbs if need be; bonds
/// between different children then are the crack; it goes through when one connected crack lies in all slabs.
Outcome judge(const BreakableBody& body, std::span<const uint32_t> fragment, const Criteria& criteria = {});

}  // namespace demolish
