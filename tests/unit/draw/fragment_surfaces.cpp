// SPDX-License-Identifier: Apache-2.0
// Reads fragments off the draw data by the plain rule "a face shows when its two cells are in different
// fragments".
#include "tests/unit/draw/fragment_surfaces.h"

#include <bit>
#include <map>
#include <random>

namespace demolish::test {
namespace {

using PositionKey = std::array<uint32_t, 3>;

PositionKey keyOf(const Float3& p) {
    return {std::bit_cast<uint32_t>(p.x + 0.0f), std::bit_cast<uint32_t>(p.y + 0.0f),
            std::bit_cast<uint32_t>(p.z + 0.0f)};
}

}  // namespace

std::vector<Soup> fragmentSurfaces(const FractureGeometry& geometry,
                                   const std::vector<uint32_t>& fragment_of_cell, uint32_t fragment_count,
                                   const std::vector<Float3>& pool) {
    std::vector<Soup> soups(fragment_count);
    for (size_t i = 0; i < geometry.exterior_indices.size(); i += 3) {
        const auto at = [&](size_t corner) {
            return geometry.exterior[geometry.exterior_indices[i + corner]];
        };
        soups[fragment_of_cell[at(0).cell]].push_back({at(0).position, at(1).position, at(2).position});
    }
    for (const InteriorFace& face : geometry.faces) {
        const uint32_t a = fragment_of_cell[face.cell_a], b = fragment_of_cell[face.cell_b];
        if (a == b) continue;
        for (uint32_t i = face.first_index; i < face.first_index + face.index_count; i += 3) {
            const auto at = [&](uint32_t corner) {
                return pool[geometry.face_vertices[face.first_vertex + geometry.face_indices[i + corner]]];
            };
            soups[a].push_back({at(0), at(1), at(2)});
            soups[b].push_back({at(0), at(2), at(1)});
        }
    }
    return soups;
}

size_t openEdges(const Soup& soup) {
    std::map<std::array<PositionKey, 2>, int> uses;
    for (const auto& triangle : soup) {
        for (int corner = 0; corner < 3; ++corner) {
            const PositionKey from = keyOf(triangle[corner]), to = keyOf(triangle[(corner + 1) % 3]);
            if (from < to) ++uses[{from, to}];
            if (to < from) --uses[{to, from}];
        }
    }
    size_t open = 0;
    for (const auto& [edge, balance] : uses) open += balance != 0;
    return open;
}

double enclosedVolume(const Soup& soup) {
    double six_volumes = 0;
    for (const auto& [a, b, c] : soup)
        six_volumes += a.x * (double(b.y) * c.z - double(b.z) * c.y) +
                       a.y * (double(b.z) * c.x - double(b.x) * c.z) +
                       a.z * (double(b.x) * c.y - double(b.y) * c.x);
    return six_volumes / 6;
}

std::vector<uint32_t> randomFragments(const FractureGeometry& geometry, uint32_t cell_count,
                                      uint32_t fragment_count, uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::vector<uint32_t>> neighbours(cell_count);
    for (const InteriorFace& face : geometry.faces) {
        neighbours[face.cell_a].push_back(face.cell_b);
        neighbours[face.cell_b].push_back(face.cell_a);
    }
    constexpr uint32_t kNone = ~0u;
    std::vector<uint32_t> fragment(cell_count, kNone);
    std::vector<uint32_t> front;
    for (uint32_t f = 0; f < fragment_count; ++f) {
        const uint32_t start = random() % cell_count;
        fragment[start] = f;
        front.push_back(start);
    }
    while (!front.empty()) {
        const size_t pick = random() % front.size();
        const uint32_t cell = front[pick];
        front[pick] = front.back();
        front.pop_back();
        for (const uint32_t next : neighbours[cell]) {
            if (fragment[next] != kNone) continue;
            fragment[next] = fragment[cell];
            front.push_back(next);
        }
    }
    for (uint32_t& f : fragment) f = f == kNone ? 0 : f;
    return fragment;
}

}  // namespace demolish::test
