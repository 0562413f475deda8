// SPDX-License-Identifier: Apache-2.0
// Bond rows of a block of particles on a lattice, and of chains, for tests of clustering and fragments.
#pragma once
#include <algorithm>
#include <vector>

#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/particles.h"

namespace demolish::test {

struct BondedGrid {
    struct Place {
        uint32_t x = 0, y = 0, z = 0;
    };
    uint32_t nx = 0, ny = 0, nz = 0;
    std::vector<uint32_t> row_start;  ///< of the particles, then of kMaxProjectiles empty slots
    std::vector<BondLink> link;

    /// Six neighbours each, all bonded; ids run along x first.
    BondedGrid(uint32_t width, uint32_t height, uint32_t depth) : nx(width), ny(height), nz(depth) {
        std::vector<std::vector<uint32_t>> rows(count());
        for (uint32_t i = 0; i < count(); ++i) {
            const Place p = placeOf(i);
            if (p.x + 1 < nx) join(rows, i, i + 1);
            if (p.y + 1 < ny) join(rows, i, i + nx);
            if (p.z + 1 < nz) join(rows, i, i + nx * ny);
        }
        setRows(rows);
    }
    explicit BondedGrid(std::vector<std::vector<uint32_t>> rows)
        : nx(static_cast<uint32_t>(rows.size())), ny(1), nz(1) {
        setRows(rows);
    }

    uint32_t count() const { return nx * ny * nz; }
    Place placeOf(uint32_t i) const { return {i % nx, i / nx % ny, i / (nx * ny)}; }

    void setState(uint32_t i, uint32_t j, PairState state) {
        for (const auto& [a, b] : {std::pair{i, j}, std::pair{j, i}})
            for (uint32_t s = row_start[a]; s < row_start[a + 1]; ++s)
                if (linkedParticle(link[s]) == b) link[s].link = linkWord(b, state);
    }
    /// Breaks the bonds for which `where(place of lower id, place of higher id)` holds.
    template <class Where>
    void cut(const Where& where) {
        for (uint32_t i = 0; i < count(); ++i)
            for (uint32_t s = row_start[i]; s < row_start[i + 1]; ++s) {
                const uint32_t j = linkedParticle(link[s]);
                if (i < j && isBonded(link[s]) && where(placeOf(i), placeOf(j)))
                    setState(i, j, PairState::kBroken);
            }
    }

    static void join(std::vector<std::vector<uint32_t>>& rows, uint32_t i, uint32_t j) {
        rows[i].push_back(j);
        rows[j].push_back(i);
    }

  private:
    void setRows(std::vector<std::vector<uint32_t>>& rows) {
        row_start.assign(1, 0);
        for (auto& row : rows) {
            std::sort(row.begin(), row.end());
            for (const uint32_t j : row) link.push_back({linkWord(j, PairState::kBonded), ~0u});
            row_start.push_back(static_cast<uint32_t>(link.size()));
        }
        row_start.resize(row_start.size() + kMaxProjectiles, row_start.back());
    }
};

/// One chain of bonds through the ids in the order given.
inline BondedGrid chainThrough(const std::vector<uint32_t>& ids) {
    std::vector<std::vector<uint32_t>> rows(ids.size());
    for (size_t k = 0; k + 1 < ids.size(); ++k) BondedGrid::join(rows, ids[k], ids[k + 1]);
    return BondedGrid(std::move(rows));
}

}  // namespace demolish::test
