// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/solver/facing_bodies.h"

#include <algorithm>

#include "sim_cuda/solver/facing_cells.h"
#include "sim_cuda/solver/pair_records.h"

namespace demolish {
namespace {

/// Of the smaller spacing of two bodies: outsides that are this far apart may come to touch as they settle.
constexpr double kFacingGap = 0.5;

bool haveRecord(const SceneTables& tables, uint32_t i, uint32_t j) {
    const auto row = [&](uint32_t of) { return tables.slots.begin() + tables.row_start[of]; };
    return std::any_of(row(i), row(i + 1), [&](const BondSlot& slot) { return slot.other == j; });
}

/// m, between the two when their outsides touch. No less than now: what begins pressed into each other is at
/// rest there.
Vec3<double> apartAtTouch(const FacingCells& cells, const SceneTables& tables) {
    const Vec3<double> now = tables.position[cells.j] - tables.position[cells.i];
    return axpy(-std::max(cells.gap, 0.0), cells.normal, now);
}

}  // namespace

void letBodiesFace(const SceneSetup& setup, SceneTables& tables) {
    const auto gap = [&](uint32_t a, uint32_t b) {
        return kFacingGap * std::min(setup.bodies[a].body->spacing, setup.bodies[b].body->spacing);
    };
    std::vector<PairRecord> records;
    for (const FacingCells& cells : facingCells(setup, tables, gap)) {
        if (haveRecord(tables, cells.i, cells.j)) continue;
        const Vec3<double> apart = apartAtTouch(cells, tables);
        records.push_back(
            {cells.i, cells.j, BondSlot::facing(cells.j, apart), BondSlot::facing(cells.i, -apart)});
    }
    if (!records.empty()) appendRecords(records, tables);
}

}  // namespace demolish
