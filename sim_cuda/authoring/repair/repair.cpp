// SPDX-License-Identifier: Apache-2.0
// The steps in order, each asked for by what the one before left open.
#include "sim_cuda/authoring/repair/repair.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/repair/disjoint_sets.h"
#include "sim_cuda/authoring/repair/doubles.h"
#include "sim_cuda/authoring/repair/dress_caps.h"
#include "sim_cuda/authoring/repair/holes.h"
#include "sim_cuda/authoring/repair/junctions.h"
#include "sim_cuda/authoring/repair/orientation.h"
#include "sim_cuda/authoring/repair/outward.h"
#include "sim_cuda/authoring/repair/parts_apart.h"
#include "sim_cuda/authoring/repair/quad_diagonals.h"
#include "sim_cuda/authoring/repair/remesh.h"
#include "sim_cuda/authoring/repair/sheets.h"
#include "sim_cuda/authoring/repair/thicken.h"
#include "sim_cuda/authoring/repair/unite.h"
#include "sim_cuda/authoring/repair/weld.h"
#include "sim_cuda/authoring/solid_checks.h"
#include "sim_cuda/authoring/unused_vertices.h"

namespace demolish {
namespace {

constexpr double kApartShare = 2e-6;  // of the diagonal

/// Cheaper than numberParts(), for meshes that may need no repair.
size_t partCount(const TriangleMesh& mesh) {
    DisjointSets sets(mesh.positions.size());
    for (const auto& t : mesh.triangles) {
        sets.join(t[0], t[1]);
        sets.join(t[0], t[2]);
    }
    size_t parts = 0;
    for (uint32_t v = 0; v < mesh.positions.size(); ++v) parts += sets.find(v) == v;
    return parts;
}

class Repair {
  public:
    Repair(TriangleMesh mesh, const RepairOptions& options)
        : options_(options), diagonal_(diagonalOf(mesh)), repair_(std::move(mesh)) {
        report_.triangles = repair_.size();
        report_.vertices = repair_.mesh.positions.size();
        report_.open_edges = openEdgeCount(repair_.mesh);
        report_.parts = partCount(repair_.mesh);
    }

    RepairedMesh done() && {
        const bool can_start =
            repair_.size() > 0 && diagonal_ > 0 && std::isfinite(diagonal_ * diagonal_ * diagonal_);
        const bool was_solid = isSolid(repair_.mesh) && !(mayHaveSheets() && hasBothSides());
        const bool is_needed = !was_solid || options_.mode == RepairMode::kRemesh || report_.parts > 1;
        if (can_start && is_needed && options_.mode != RepairMode::kOff) {
            if (was_solid) {
                numberParts(repair_);
                report_.parts = repair_.parts;
            } else {
                close();
            }
            if (repair_.size() > 0 && isSolid(repair_.mesh)) settleInside();
        }
        report_.triangles_after = repair_.size();
        if (!report_.untouched) dressCaps(repair_);
        RepairedMesh result;
        result.mesh = std::move(repair_.mesh);
        if (!report_.untouched) result.source = std::move(repair_.source);
        result.report = report_;
        return result;
    }

  private:
    bool mayRemesh() const { return options_.mode != RepairMode::kExact; }

    /// Cheaper than to ask each part; of one part that is large enough it is settled.
    bool mayHaveSheets() const {
        return options_.mode != RepairMode::kOff &&
               (report_.parts > 1 ||
                isFlat(enclosedVolume(repair_.mesh), surfaceArea(repair_.mesh), diagonal_));
    }

    /// Sheets whose sides were cut along different diagonals are closed, and no bodies.
    bool hasBothSides() {
        numberParts(repair_);
        const std::vector<PartFacts> facts = factsOfParts(repair_, {});
        const bool any_flat = std::any_of(facts.begin(), facts.end(), [](const PartFacts& part) {
            return isFlat(part.volume, part.area, part.diagonal());
        });
        return any_flat && alignDiagonals(repair_) > 0;
    }

    void close() {
        report_.untouched = false;
        report_.welded = weldNear(repair_, kWeldShare * diagonal_);
        alignDiagonals(repair_);
        const DoubleCounts doubles = dropDoubles(repair_);
        report_.doubles = doubles.same + 2 * doubles.opposite_both + doubles.opposite_one;
        if (repair_.size() == 0) return;
        if (isSolid(repair_.mesh)) {
            dropUnusedVertices(repair_.mesh);
            numberParts(repair_);
            report_.parts = repair_.parts;
            return;
        }
        const Orientation orientation = orientPatches(repair_);
        report_.turned_triangles = orientation.turned;
        report_.walls = solveJunctions(repair_).walls;
        report_.parts = repair_.parts;
        if (repair_.size() > 0) fillAndThicken(orientation.patch_touched);
        dropUnusedVertices(repair_.mesh);
    }

    void fillAndThicken(const std::vector<char>& patch_touched) {
        const std::vector<HoleCounts> holes = fillHoles(repair_);
        std::vector<PartFacts> facts = factsOfParts(repair_, patch_touched);
        const OutwardCounts outward = turnOutward(repair_, facts);
        report_.turned_parts = outward.turned;
        report_.cavities = outward.cavities;
        findSheets(repair_, facts);
        const bool any_sheet =
            std::any_of(facts.begin(), facts.end(), [](const PartFacts& part) { return part.is_sheet; });
        for (size_t p = 0; p < facts.size(); ++p) {
            if (facts[p].is_sheet) continue;
            report_.holes += holes[p].holes;
            report_.longest_hole = std::max(report_.longest_hole, holes[p].longest);
        }
        if (any_sheet && sheetsEncloseSolid(repair_, facts) && closeWalls()) return;
        thicken(facts);
    }

    /// The file's triangles alone, or all others.
    RepairMesh only(bool of_file) const {
        std::vector<char> flags(repair_.size());
        for (size_t t = 0; t < repair_.size(); ++t) flags[t] = (repair_.source[t] != kNoSource) == of_file;
        RepairMesh taken = repair_;
        taken.keep(flags);
        return taken;
    }

    /// What looks like sheets bounds a solid: capped if that agrees with the winding number, else remeshed.
    /// False, and nothing changed, where that encloses nothing: planes in a row, one behind the other.
    bool closeWalls() {
        constexpr double kAgrees = 0.04, kNothing = 1e-6;  // of the diagonal's cube
        const RepairMesh raw = only(true), caps = only(false);
        RepairMesh before = repair_;
        separateParts();
        const bool is_solid = isSolid(repair_.mesh);
        if (is_solid && (!mayRemesh() || (windingDifference(repair_.mesh, caps.mesh) < kAgrees &&
                                          !sampleWinding(repair_.mesh).isInsideOut())))
            return true;
        if (mayRemesh()) remesh(raw, false, RemeshCause::kWallsOfSolid);
        const double least = kNothing * diagonal_ * diagonal_ * diagonal_;
        if (report_.remeshed != RemeshCause::kNone || enclosedVolume(repair_.mesh) > least) return true;
        repair_ = std::move(before);
        return false;
    }

    void thicken(const std::vector<PartFacts>& facts) {
        const std::vector<double> thickness = sheetThickness(facts, options_.thickness);
        report_.sheets =
            size_t(std::count_if(thickness.begin(), thickness.end(), [](double t) { return t > 0; }));
        report_.thickness = *std::max_element(thickness.begin(), thickness.end());
        const RepairMesh raw = only(true);
        if (report_.sheets > 0) thickenSheets(repair_, thickness);
        separateParts();
        if (!isSolid(repair_.mesh) && mayRemesh()) remesh(raw, false, RemeshCause::kStillOpen);
    }

    void separateParts() {
        glueParts(repair_);
        setPartsApart(repair_, kApartShare * diagonal_);
        settleDoubles(repair_);
        dropUnusedVertices(repair_.mesh);
    }

    /// Keeps what was there if the new surface is none.
    void remesh(const RepairMesh& from, bool is_closed, RemeshCause cause) {
        RepairMesh surface = remeshed(from, is_closed);
        if (!isSolid(surface.mesh)) return;
        repair_ = std::move(surface);
        report_.remeshed = cause;
        report_.untouched = false;
    }

    void settleInside() {
        if (options_.mode == RepairMode::kRemesh && report_.remeshed == RemeshCause::kNone) {
            remesh(repair_, true, RemeshCause::kAsked);
            return;
        }
        const WindingSamples samples = sampleWinding(repair_.mesh);
        report_.overlap = samples.overlap();
        if (!mayRemesh()) return;
        if (samples.isInsideOut()) {
            remesh(repair_, true, RemeshCause::kInsideOut);
        } else if (samples.overlap() > kMostOverlap) {
            report_.united = uniteParts(repair_, samples);
            if (report_.united > 0) report_.untouched = false;
        }
    }

    RepairOptions options_;
    double diagonal_;
    RepairMesh repair_;
    RepairReport report_;
};

}  // namespace

RepairedMesh repairMesh(TriangleMesh mesh, const RepairOptions& options) {
    return Repair(std::move(mesh), options).done();
}

RepairedMesh withNewSurface(const RepairedMesh& closed, RemeshCause cause) {
    RepairMesh original(closed.mesh);
    if (!closed.source.empty()) original.source = closed.source;
    RepairMesh surface = remeshed(original, true);
    RepairedMesh result{std::move(surface.mesh), std::move(surface.source), closed.report};
    result.report.remeshed = cause;
    result.report.untouched = false;
    result.report.triangles_after = result.mesh.triangles.size();
    return result;
}

}  // namespace demolish
