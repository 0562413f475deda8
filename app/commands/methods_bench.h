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

    void tellDrawnBy(const std::string& renderer, PictureSize size);
};
/// Those that are named, "all" or with commas, in the order of the paper's figure. Throws UsageError.
std::vector<Method> methodsToCompare(const std::string& names);

/// Each method runs the plan, timed, without the energy ledger; then the same frames hit from another side,
/// with it and not drawn. All have the same cells. Ours on the CPU's cores gives the bits of ours: beside it
/// it is timed alone, and without a GPU not even that. Fills in the place. Throws Interrupted, NumericalError
/// and the errors of buildShot().
std::vector<MethodRow> compareMethods(const Shot& shot, std::span<const Method> methods,
                                      const BenchPlan& plan, const ShotOptions& options, PictureSize size,
                                      MethodsPlace& place);

std::string methodsTable(std::span<const MethodRow> rows, const MethodsPlace& place);
std::string methodsJson(std::span<const MethodRow> rows, const MethodsPlace& place);

}  // namespace demolish
