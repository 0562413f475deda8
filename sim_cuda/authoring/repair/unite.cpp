// SPDX-License-Identifier: Apache-2.0
// The parts about a doubled point belong together.
#include "sim_cuda/authoring/repair/unite.h"

#include <algorithm>
#include <utility>

#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/repair/disjoint_sets.h"
#include "sim_cuda/authoring/repair/orientation.h"
#include "sim_cuda/authoring/repair/parts_about.h"
#include "sim_cuda/authoring/repair/remesh.h"
#include "sim_cuda/authoring/unused_vertices.h"

namespace demolish {
namespace {

constexpr size_t kMostGroups = 16;     // with a surface each; more are put together
constexpr size_t kMostPoints = 20000;  // of those looked at

RepairMesh takenOut(const RepairMesh& repair, const std::vector<char>& flags) {
    RepairMesh taken = repair;
    taken.keep(flags);
    dropUnusedVertices(taken.mesh);
    return taken;
}

/// Group of each part, and which groups hold something twice.
struct Groups {
    std::vector<uint32_t> of_part;
    std::vector<char> overlaps;  // by group
};

Groups numbered(DisjointSets& sets, const std::vector<char>& is_doubled) {
    Groups groups;
    groups.overlaps.assign(sets.number(groups.of_part), 0);
    for (size_t p = 0; p < is_doubled.size(); ++p)
        if (is_doubled[p] != 0) groups.overlaps[groups.of_part[p]] = 1;
    if (size_t(std::count(groups.overlaps.begin(), groups.overlaps.end(), 1)) <= kMostGroups) return groups;
    const auto first = uint32_t(std::find(is_doubled.begin(), is_doubled.end(), 1) - is_doubled.begin());
    for (uint32_t p = first; p < is_doubled.size(); ++p)
        if (is_doubled[p] != 0) sets.join(first, p);
    return numbered(sets, is_doubled);
}

/// By part: is it inside out? About the middle of the mesh.
std::vector<char> hollowParts(const RepairMesh& repair) {
    const Bounds bounds = boundsOf(repair.mesh.positions);
    const Double3 middle = (bounds.lower + bounds.upper) * 0.5;
    std::vector<double> six_volumes(repair.parts, 0);
    for (size_t t = 0; t < repair.size(); ++t)
        six_volumes[repair.part[t]] +=
            dot(repair.at(t, 0) - middle, cross(repair.at(t, 1) - middle, repair.at(t, 2) - middle));
    std::vector<char> is_hollow(repair.parts);
    for (size_t p = 0; p < is_hollow.size(); ++p) is_hollow[p] = six_volumes[p] < 0;
    return is_hollow;
}

Groups groupsOf(const RepairMesh& repair, const std::vector<Double3>& doubled) {
    PartsAbout parts(repair);
    const std::vector<char> is_hollow = hollowParts(repair);
    std::vector<Double3> points;
    const size_t step = std::max<size_t>(1, doubled.size() / kMostPoints);
    for (size_t i = 0; i < doubled.size(); i += step) points.push_back(doubled[i]);
    DisjointSets sets(repair.parts);
    std::vector<char> is_doubled(repair.parts, 0);
    for (const std::vector<uint32_t>& about : parts.eachOfGrid(points))
        for (const uint32_t p : about) {
            sets.join(about[0], p);
            is_doubled[p] = 1;
        }
    std::vector<Double3> of_hollows;  // a point of the surface of each
    std::vector<uint32_t> hollows;
    std::vector<char> is_known = is_hollow;
    for (size_t t = 0; t < repair.size(); ++t) {
        const uint32_t p = repair.part[t];
        if (is_hollow[p] == 0 || is_known[p] == 0) continue;
        is_known[p] = 0;
        hollows.push_back(p);
        of_hollows.push_back(repair.middle(t));
    }
    const auto hosts = parts.each(of_hollows);
    for (size_t i = 0; i < hollows.size(); ++i)
        for (const uint32_t host : hosts[i])
            if (is_hollow[host] == 0) sets.join(hollows[i], host);
    return numbered(sets, is_doubled);
}

void append(RepairMesh& repair, const RepairMesh& surface) {
    const auto first = uint32_t(repair.mesh.positions.size());
    repair.mesh.positions.insert(repair.mesh.positions.end(), surface.mesh.positions.begin(),
                                 surface.mesh.positions.end());
    for (size_t t = 0; t < surface.size(); ++t) {
        const auto [a, b, c] = surface.mesh.triangles[t];
        repair.add({first + a, first + b, first + c}, surface.mesh.corners[t], surface.source[t],
                   repair.patches, repair.parts);
    }
    ++repair.patches;
    ++repair.parts;
}

/// The parts of each group that overlap, and the surface that they get together.
class GroupSurfaces {
  public:
    GroupSurfaces(const RepairMesh& repair, const Groups& groups) : repair_(repair), groups_(groups) {
        std::vector<char> flags(repair.size());
        for (uint32_t group = 0; group < groups.overlaps.size(); ++group) {
            if (groups.overlaps[group] == 0) continue;
            for (size_t t = 0; t < repair.size(); ++t) flags[t] = groups.of_part[repair.part[t]] == group;
            parts_.push_back(takenOut(repair, flags));
            surfaces_.push_back(remeshed(parts_.back(), true, kRemeshCells));
        }
    }

    /// On a grid twice as fine where a surface holds less than this share of what its parts hold, which may
    /// be because they overlap and may be because they are thin.
    void refine(double share) {
        for (size_t k = 0; k < parts_.size(); ++k)
            if (enclosedVolume(surfaces_[k].mesh) < share * enclosedVolume(parts_[k].mesh))
                surfaces_[k] = remeshed(parts_[k], true, 2 * kRemeshCells);
    }

    /// With all parts that overlap nothing.
    RepairMesh united() const {
        std::vector<char> flags(repair_.size());
        for (size_t t = 0; t < repair_.size(); ++t)
            flags[t] = groups_.overlaps[groups_.of_part[repair_.part[t]]] == 0;
        RepairMesh result = takenOut(repair_, flags);
        for (const RepairMesh& surface : surfaces_) append(result, surface);
        return result;
    }

  private:
    const RepairMesh& repair_;
    const Groups& groups_;
    std::vector<RepairMesh> parts_, surfaces_;
};

}  // namespace

size_t uniteParts(RepairMesh& repair, const WindingSamples& samples) {
    constexpr double kAllThere = 0.97, kMostThere = 0.9;
    numberParts(repair);
    const Groups groups = groupsOf(repair, samples.doubled_points);
    GroupSurfaces surfaces(repair, groups);
    RepairMesh result = surfaces.united();
    if (enclosedVolume(result.mesh) < kAllThere * samples.volume) {
        surfaces.refine(kAllThere);
        result = surfaces.united();
    }
    if (!(enclosedVolume(result.mesh) > kMostThere * samples.volume)) return 0;
    repair = std::move(result);
    return size_t(std::count_if(groups.of_part.begin(), groups.of_part.end(),
                                [&](uint32_t group) { return groups.overlaps[group] != 0; }));
}

}  // namespace demolish
