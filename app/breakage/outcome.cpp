// SPDX-License-Identifier: Apache-2.0
// Fragment volumes, adoption of crumbs, the connected crack.
#include "app/breakage/outcome.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

namespace demolish {
namespace {

constexpr uint32_t kNobody = 0xffffffffu;

std::map<uint32_t, double> fragmentVolumes(const BreakableBody& body, std::span<const uint32_t> fragment) {
    std::map<uint32_t, double> volumes;
    for (size_t i = 0; i < fragment.size(); ++i) volumes[fragment[i]] += body.particles[i].volume;
    return volumes;
}

/// Every particle's child: its own fragment if that is one, else the lowest of the children first reached
/// over the bonds at rest.
std::vector<uint32_t> adoptCrumbs(const BreakableBody& body, std::span<const uint32_t> fragment,
                                  const std::map<uint32_t, double>& volumes, double least) {
    std::vector<uint32_t> child(fragment.size(), kNobody);
    for (size_t i = 0; i < fragment.size(); ++i)
        if (volumes.at(fragment[i]) >= least) child[i] = fragment[i];
    for (bool grown = true; grown;) {
        grown = false;
        std::vector<uint32_t> next = child;
        const auto take = [&](uint32_t crumb, uint32_t neighbour) {
            if (child[crumb] != kNobody || child[neighbour] == kNobody) return;
            next[crumb] = std::min(next[crumb], child[neighbour]);
            grown = true;
        };
        for (const BondGeometry& bond : body.bonds) {
            take(bond.i, bond.j);
            take(bond.j, bond.i);
        }
        child.swap(next);
    }
    return child;
}

class DisjointSets {
  public:
    explicit DisjointSets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    uint32_t rootOf(uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(uint32_t a, uint32_t b) { parent_[rootOf(a)] = rootOf(b); }

  private:
    std::vector<uint32_t> parent_;
};

bool crackGoesThrough(const BreakableBody& body, const std::vector<uint32_t>& child, uint32_t slabs) {
    const double low = body.bounds_min.y, height = body.bounds_max.y - low;
    DisjointSets cracks(child.size());
    const auto isCrack = [&](const BondGeometry& bond) { return child[bond.i] != child[bond.j]; };
    for (const BondGeometry& bond : body.bonds)
        if (isCrack(bond)) cracks.join(bond.i, bond.j);
    std::map<uint32_t, std::vector<bool>> seen;
    for (const BondGeometry& bond : body.bonds) {
        if (!isCrack(bond)) continue;
        auto& slices = seen.try_emplace(cracks.rootOf(bond.i), slabs, false).first->second;
        const double place = (bond.centroid.y - low) / height * slabs;
        slices[static_cast<size_t>(std::clamp(place, 0.0, slabs - 1.0))] = true;
    }
    return std::any_of(seen.begin(), seen.end(), [](const auto& crack) {
        return std::all_of(crack.second.begin(), crack.second.end(), [](bool in_slab) { return in_slab; });
    });
}

}  // namespace

bool isBroken(const Outcome& outcome, BreakRule rule, const Criteria& criteria) {
    switch (rule) {
        case BreakRule::kMeridional:
            return outcome.meridional;
        case BreakRule::kFlaps:
            return outcome.children >= criteria.flaps;
        case BreakRule::kLargest:
            break;
    }
    return outcome.split;
}

Outcome judge(const BreakableBody& body, std::span<const uint32_t> fragment, const Criteria& criteria) {
    const auto volumes = fragmentVolumes(body, fragment);
    double whole = 0, largest = 0;
    for (const auto& [label, volume] : volumes) {
        whole += volume;
        largest = std::max(largest, volume);
    }
    const double least = criteria.child_share * whole;
    Outcome outcome;
    outcome.largest = largest / whole;
    outcome.children = static_cast<uint32_t>(std::count_if(
        volumes.begin(), volumes.end(), [&](const auto& entry) { return entry.second >= least; }));
    outcome.split = outcome.largest < criteria.intact_share;
    outcome.meridional = outcome.children >= 2 &&
                         crackGoesThrough(body, adoptCrumbs(body, fragment, volumes, least), criteria.slabs);
    return outcome;
}

}  // namespace demolish
