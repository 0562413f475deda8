// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/solver/pair_records.h"

#include <algorithm>

namespace demolish {
namespace {

/// A slot, and where it was before: record k has the places 2 k and 2 k + 1 after all others.
struct Entry {
    BondSlot slot;
    size_t former = 0;
};

/// Per particle, by the id of the other end.
std::vector<std::vector<Entry>> rowsWith(const std::vector<PairRecord>& records, const SceneTables& tables) {
    std::vector<std::vector<Entry>> rows(tables.counts.in_bodies);
    for (uint32_t i = 0; i < rows.size(); ++i)
        for (uint32_t s = tables.row_start[i]; s < tables.row_start[i + 1]; ++s)
            rows[i].push_back({tables.slots[s], s});
    const size_t former_slots = tables.slots.size();
    for (size_t k = 0; k < records.size(); ++k) {
        rows[records[k].i].push_back({records[k].at_i, former_slots + 2 * k});
        rows[records[k].j].push_back({records[k].at_j, former_slots + 2 * k + 1});
    }
    for (std::vector<Entry>& row : rows)
        std::sort(row.begin(), row.end(),
                  [](const Entry& a, const Entry& b) { return a.slot.other < b.slot.other; });
    return rows;
}

}  // namespace

void appendRecords(const std::vector<PairRecord>& records, SceneTables& tables) {
    const auto rows = rowsWith(records, tables);
    const size_t former_slots = tables.slots.size();
    std::vector<uint32_t> place(former_slots + 2 * records.size());
    std::vector<BondSlot> slots;
    for (size_t i = 0; i < rows.size(); ++i) {
        tables.row_start[i] = static_cast<uint32_t>(slots.size());
        for (const Entry& entry : rows[i]) {
            place[entry.former] = static_cast<uint32_t>(slots.size());
            slots.push_back(entry.slot);
        }
    }
    for (size_t i = rows.size(); i < tables.row_start.size(); ++i)
        tables.row_start[i] = static_cast<uint32_t>(slots.size());
    std::vector<uint32_t> twin(slots.size());
    for (size_t s = 0; s < former_slots; ++s) twin[place[s]] = place[tables.twin[s]];
    for (uint32_t& slot : tables.slot_of_bond) slot = place[slot];
    for (size_t k = 0; k < records.size(); ++k) {
        const uint32_t here = place[former_slots + 2 * k], there = place[former_slots + 2 * k + 1];
        twin[here] = there;
        twin[there] = here;
        if (records[k].at_i.is_bond) tables.slot_of_bond.push_back(here);
    }
    tables.twin = std::move(twin);
    tables.slots = std::move(slots);
}

}  // namespace demolish
