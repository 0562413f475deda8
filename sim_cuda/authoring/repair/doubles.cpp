// SPDX-License-Identifier: Apache-2.0
// Doubles lie side by side once the triangles are sorted by their vertices.
#include "sim_cuda/authoring/repair/doubles.h"

#include <tbb/parallel_sort.h>

#include <algorithm>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/repair/disjoint_sets.h"
#include "sim_cuda/authoring/repair/edge_uses.h"

namespace demolish {
namespace {

/// Triangles of one set of vertices by the side that is out.
struct Doubles {
    std::array<std::vector<uint32_t>, 2> sides;
};

struct Entry {
    Triangle sorted;
    bool is_even;
    uint32_t triangle;
};

/// Only sets of vertices with more than one triangle, in order of them.
std::vector<Doubles> doublesOf(const TriangleMesh& mesh) {
    std::vector<Entry> entries;
    entries.reserve(mesh.triangles.size());
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        Triangle k = mesh.triangles[t];
        const bool is_even = (k[0] < k[1]) + (k[1] < k[2]) + (k[2] < k[0]) == 2;
        std::sort(k.begin(), k.end());
        entries.push_back({k, is_even, t});
    }
    tbb::parallel_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.sorted != b.sorted ? a.sorted < b.sorted : a.triangle < b.triangle;
    });
    std::vector<Doubles> all;
    for (size_t begin = 0; begin < entries.size();) {
        size_t end = begin + 1;
        while (end < entries.size() && entries[end].sorted == entries[begin].sorted) ++end;
        if (end - begin > 1) {
            Doubles& doubles = all.emplace_back();
            for (size_t i = begin; i < end; ++i)
                doubles.sides[entries[i].is_even].push_back(entries[i].triangle);
        }
        begin = end;
    }
    return all;
}

/// Flags of pairs (by their place in `pairs`) that go altogether. `pair_of` is that place by triangle, for
/// one triangle of each pair; `keep` has neither of a pair's.
std::vector<char> wallsAmong(const RepairMesh& repair, size_t pair_count,
                             const std::vector<uint32_t>& pair_of, const std::vector<char>& keep) {
    DisjointSets groups(pair_count);
    std::vector<std::array<size_t, 2>> border(pair_count);  // edges with an even, an odd number of others
    const std::vector<EdgeUse> uses = edgeUses(repair.mesh);
    forEachEdge(uses, [&](std::span<const EdgeUse> edge) {
        size_t others = 0;
        for (const EdgeUse& use : edge) others += keep[use.triangle] != 0;
        uint32_t first = kNoSource;
        for (const EdgeUse& use : edge) {
            const uint32_t pair = pair_of[use.triangle];
            if (pair == kNoSource) continue;
            if (others > 0)
                ++border[pair][others % 2];
            else if (first == kNoSource)
                first = pair;
            else
                groups.join(first, pair);
        }
    });
    std::vector<uint32_t> group_of;
    std::vector<std::array<size_t, 2>> of_group(groups.number(group_of));
    for (size_t i = 0; i < pair_count; ++i)
        for (size_t odd = 0; odd < 2; ++odd) of_group[group_of[i]][odd] += border[i][odd];
    std::vector<char> goes(pair_count);
    for (size_t i = 0; i < pair_count; ++i) goes[i] = of_group[group_of[i]][0] > of_group[group_of[i]][1];
    return goes;
}

void splitInMiddle(RepairMesh& repair, uint32_t triangle) {
    const Triangle k = repair.mesh.triangles[triangle];
    const Corners c = repair.mesh.corners[triangle];
    const auto middle = uint32_t(repair.mesh.positions.size());
    repair.mesh.positions.push_back(repair.middle(triangle));
    for (size_t e = 0; e < 3; ++e)
        repair.add({k[e], k[(e + 1) % 3], middle}, {c[e], c[(e + 1) % 3], c[(e + 2) % 3]},
                   repair.source[triangle], repair.patch[triangle], repair.part[triangle]);
}

}  // namespace

DoubleCounts dropDoubles(RepairMesh& repair) {
    DoubleCounts counts;
    std::vector<char> keep(repair.size(), 1);
    std::vector<uint32_t> pair_of(repair.size(), kNoSource), pairs;
    for (const Doubles& doubles : doublesOf(repair.mesh)) {
        for (const auto& side : doubles.sides)
            for (size_t i = 1; i < side.size(); ++i) {
                keep[side[i]] = 0;
                ++counts.same;
            }
        if (doubles.sides[0].empty() || doubles.sides[1].empty()) continue;
        const uint32_t first = std::min(doubles.sides[0][0], doubles.sides[1][0]);
        keep[doubles.sides[0][0]] = keep[doubles.sides[1][0]] = 0;
        pair_of[first] = uint32_t(pairs.size());
        pairs.push_back(first);
    }
    if (!pairs.empty()) {
        const std::vector<char> goes = wallsAmong(repair, pairs.size(), pair_of, keep);
        for (size_t i = 0; i < pairs.size(); ++i) {
            ++(goes[i] != 0 ? counts.opposite_both : counts.opposite_one);
            if (goes[i] == 0) keep[pairs[i]] = 1;
        }
    }
    repair.keep(keep);
    return counts;
}

void settleDoubles(RepairMesh& repair) {
    std::vector<char> keep(repair.size(), 1);
    for (Doubles& doubles : doublesOf(repair.mesh)) {
        auto& [odd, even] = doubles.sides;
        const size_t pairs = std::min(odd.size(), even.size());
        for (auto* side : {&odd, &even}) {
            for (size_t i = 0; i < pairs; ++i) keep[(*side)[i]] = 0;
            for (size_t i = pairs + 1; i < side->size(); ++i) {
                keep[(*side)[i]] = 0;
                splitInMiddle(repair, (*side)[i]);
            }
        }
    }
    keep.resize(repair.size(), 1);
    repair.keep(keep);
}

void glueParts(RepairMesh& repair) {
    std::vector<char> keep(repair.size(), 1);
    DisjointSets joined(repair.parts);
    for (const Doubles& doubles : doublesOf(repair.mesh)) {
        const auto& [odd, even] = doubles.sides;
        for (size_t i = 0; i < std::min(odd.size(), even.size()); ++i) {
            keep[odd[i]] = keep[even[i]] = 0;
            joined.join(repair.part[odd[i]], repair.part[even[i]]);
        }
    }
    std::vector<uint32_t> number;
    repair.parts = joined.number(number);
    for (uint32_t& part : repair.part) part = number[part];
    repair.keep(keep);
}

}  // namespace demolish
