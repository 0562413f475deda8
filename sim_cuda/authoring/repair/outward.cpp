// SPDX-License-Identifier: Apache-2.0
// Signs of volumes first, then the winding number of the positive parts at some points of each negative one.
#include "sim_cuda/authoring/repair/outward.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/repair/winding_number.h"

namespace demolish {
namespace {

constexpr size_t kProbes = 20;

/// Flags of parts that lie inside the positive ones, of those flagged as candidates. The mesh of the winding
/// number has positive parts with their outside out.
std::vector<char> insideOthers(const RepairMesh& filled, const std::vector<PartFacts>& facts,
                               const std::vector<char>& turn, const std::vector<char>& candidate) {
    RepairMesh outward = filled;
    std::vector<char> positive(filled.size());
    for (size_t t = 0; t < filled.size(); ++t) {
        const uint32_t part = filled.part[t];
        positive[t] = (facts[part].volume > 0) != (turn[part] != 0);
        if (positive[t] != 0 && turn[part] != 0) outward.turn(t);
    }
    const WindingNumber winding(outward.mesh, positive);
    std::vector<size_t> probes(facts.size(), 0), inside(facts.size(), 0);
    for (size_t t = 0; t < filled.size(); ++t) {
        const uint32_t part = filled.part[t];
        if (candidate[part] == 0 || probes[part] == kProbes) continue;
        ++probes[part];
        inside[part] += winding.at(filled.middle(t)) > 0.5;
    }
    std::vector<char> is_inside(facts.size());
    for (size_t p = 0; p < facts.size(); ++p) is_inside[p] = probes[p] > 0 && inside[p] == probes[p];
    return is_inside;
}

}  // namespace

OutwardCounts turnOutward(RepairMesh& filled, std::vector<PartFacts>& facts) {
    OutwardCounts counts;
    if (facts.empty()) return counts;
    const auto largest = std::max_element(
        facts.begin(), facts.end(),
        [](const PartFacts& a, const PartFacts& b) { return std::abs(a.volume) < std::abs(b.volume); });
    std::vector<char> turn(facts.size(), largest->volume < 0), candidate(facts.size(), 0);
    const auto isNegative = [&](size_t p) {
        return turn[p] != 0 ? facts[p].volume > 0 : facts[p].volume < 0;
    };
    bool any = false;
    for (size_t p = 0; p < facts.size(); ++p) {
        candidate[p] = isNegative(p) && !facts[p].was_open && !facts[p].was_touched;
        any = any || candidate[p] != 0;
    }
    const std::vector<char> is_inside =
        any ? insideOthers(filled, facts, turn, candidate) : std::vector<char>(facts.size(), 0);
    for (size_t p = 0; p < facts.size(); ++p) {
        if (!isNegative(p)) continue;
        facts[p].is_cavity = candidate[p] != 0 && is_inside[p] != 0;
        if (!facts[p].is_cavity) turn[p] ^= 1;
        counts.cavities += facts[p].is_cavity;
    }
    for (size_t t = 0; t < filled.size(); ++t)
        if (turn[filled.part[t]] != 0) filled.turn(t);
    for (size_t p = 0; p < facts.size(); ++p) {
        if (turn[p] == 0) continue;
        facts[p].volume = -facts[p].volume;
        ++counts.turned;
    }
    return counts;
}

}  // namespace demolish
