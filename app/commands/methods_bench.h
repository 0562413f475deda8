// SPDX-License-Identifier: Apache-2.0
// bench --methods: one shot by every method, in the order of the paper's Fig. 5, in one table.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "app/commands/bench_run.h"
#include "app/compare/method_row.h"

namespace demolish {

/// What was run, and where.
struct MethodsPlace {
    std::string scene, drawn_by;
    uint32_t particles = 0, bodies = 0;
    uint64_t frames = 0;
};
/// Each method runs the plan, timed, without the energy ledger; then the same frames hit from another side,
/// with it and not drawn. All have the same cells. Without a GPU ours is what runs on the CPU's cores: one
/// run stands for both. Fills in the place. Throws Interrupted, NumericalError and the errors of buildShot().
std::vector<MethodRow> compareMethods(const Shot& shot, const BenchPlan& plan, const ShotOptions& options,
                                      PictureSize size, MethodsPlace& place);

std::string methodsTable(std::span<const MethodRow> rows, const MethodsPlace& place);
std::string methodsJson(std::span<const MethodRow> rows, const MethodsPlace& place);

}  // namespace demolish
