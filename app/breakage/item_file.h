// SPDX-License-Identifier: Apache-2.0
// Results of items on disk: whole or not there, the same bytes however often an item is computed.
#pragma once
#include <optional>
#include <string>

#include "app/breakage/batch_run.h"

namespace demolish {

std::filesystem::path itemFile(const std::filesystem::path& folder, size_t item);

std::string itemJson(const BreakagePlan& plan, size_t item, const std::vector<BreakageRun>& runs,
                     const ItemResult& result);
void writeItem(const std::filesystem::path& folder, const BreakagePlan& plan, size_t item,
               const std::vector<BreakageRun>& runs, const ItemResult& result);

/// Nothing if there is no such file. Throws InputFileError when it belongs to another plan or is no item.
std::optional<ItemResult> readItem(const std::filesystem::path& folder, const BreakagePlan& plan, size_t item,
                                   const std::vector<BreakageRun>& runs);

}  // namespace demolish
