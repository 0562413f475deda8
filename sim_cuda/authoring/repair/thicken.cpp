// SPDX-License-Identifier: Apache-2.0
// Vertices move along normals weighted by angle, farther where faces meet at a slant.
#include "sim_cuda/authoring/repair/thicken.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/repair/edge_uses.h"

namespace demolish {
namespace {

constexpr double kMostStretch = 1.6;  // of the offset at corners, or spikes would grow

/// One patch of a sheet with vertices of its own.
class Plate {
  public:
    Plate(const RepairMesh& sheet, std::vector<uint32_t> triangles)
        : sheet_(sheet), triangles_(std::move(triangles)) {
        for (const uint32_t t : triangles_) {
            Triangle own;
            for (size_t k = 0; k < 3; ++k) own[k] = idOf(sheet.mesh.triangles[t][k]);
            own_.triangles.push_back(own);
        }
        findOffsets();
    }

    void addTo(RepairMesh& solid, double thickness, uint32_t part) {
        auto& positions = solid.mesh.positions;
        first_ = uint32_t(positions.size());
        for (size_t v = 0; v < vertices_.size(); ++v)
            for (const double side : {0.5, -0.5})
                positions.push_back(sheet_.mesh.positions[vertices_[v]] + offsets_[v] * (side * thickness));
        for (size_t i = 0; i < triangles_.size(); ++i) {
            const uint32_t t = triangles_[i];
            const auto [a, b, c] = own_.triangles[i];
            const Corners& corners = sheet_.mesh.corners[t];
            solid.add({front(a), front(b), front(c)}, corners, sheet_.source[t], solid.patches, part);
            solid.add({back(a), back(c), back(b)}, turned(corners), sheet_.source[t], solid.patches, part);
        }
        const std::vector<EdgeUse> uses = edgeUses(own_);
        forEachEdge(uses, [&](std::span<const EdgeUse> edge) { addStrips(solid, edge, part); });
        ++solid.patches;
    }

  private:
    uint32_t front(uint32_t v) const { return first_ + 2 * v; }
    uint32_t back(uint32_t v) const { return first_ + 2 * v + 1; }

    uint32_t idOf(uint32_t vertex) {
        const auto [place, is_new] = ids_.try_emplace(vertex, uint32_t(vertices_.size()));
        if (is_new) vertices_.push_back(vertex);
        return place->second;
    }

    void findOffsets() {
        std::vector<Double3> normal(vertices_.size());
        for (size_t i = 0; i < triangles_.size(); ++i)
            for (size_t k = 0; k < 3; ++k) {
                const Double3 &p = sheet_.at(triangles_[i], int(k)),
                              a = normalized(sheet_.at(triangles_[i], int((k + 1) % 3)) - p),
                              b = normalized(sheet_.at(triangles_[i], int((k + 2) % 3)) - p);
                normal[own_.triangles[i][k]] +=
                    sheet_.normal(triangles_[i]) * std::acos(std::clamp(dot(a, b), -1.0, 1.0));
            }
        for (Double3& n : normal) n = normalized(n);
        std::vector<double> cosines(vertices_.size(), 0), faces(vertices_.size(), 0);
        for (size_t i = 0; i < triangles_.size(); ++i)
            for (const uint32_t v : own_.triangles[i]) {
                const Double3 of_face = sheet_.normal(triangles_[i]);
                if (lengthSquared(normal[v]) == 0) normal[v] = of_face;  // all faces cancelled
                cosines[v] += dot(of_face, normal[v]);
                faces[v] += 1;
            }
        offsets_.resize(vertices_.size());
        for (size_t v = 0; v < offsets_.size(); ++v)
            offsets_[v] = normal[v] * std::clamp(faces[v] / std::max(cosines[v], 1e-9), 1.0, kMostStretch);
    }

    /// From the front's rim to the back's; a second strip on the same edge gets a vertex in its middle, or it
    /// would be a double.
    void addStrips(RepairMesh& solid, std::span<const EdgeUse> edge, uint32_t part) const {
        const int balance = imbalanceOf(edge);
        const uint32_t from = balance > 0 ? edge[0].low : edge[0].high,
                       to = balance > 0 ? edge[0].high : edge[0].low;
        auto& positions = solid.mesh.positions;
        for (int i = 0; i < std::abs(balance); ++i) {
            if (i == 0) {
                solid.addOwn({front(to), front(from), back(from)}, solid.patches, part);
                solid.addOwn({front(to), back(from), back(to)}, solid.patches, part);
                continue;
            }
            const auto middle = uint32_t(positions.size());
            positions.push_back((positions[front(from)] + positions[back(to)]) * 0.5);
            for (const auto& [a, b] : {std::pair{front(to), front(from)},
                                       {front(from), back(from)},
                                       {back(from), back(to)},
                                       {back(to), front(to)}})
                solid.addOwn({a, b, middle}, solid.patches, part);
        }
    }

    const RepairMesh& sheet_;
    std::vector<uint32_t> triangles_;  // of the sheet
    std::unordered_map<uint32_t, uint32_t> ids_;
    std::vector<uint32_t> vertices_;  // of the sheet, by own number
    std::vector<Double3> offsets_;    // unit at flat places
    TriangleMesh own_;                // triangles of own numbers
    uint32_t first_ = 0;
};

}  // namespace

void thickenSheets(RepairMesh& filled, const std::vector<double>& thickness) {
    std::vector<std::vector<uint32_t>> of_patch(filled.patches);
    RepairMesh solid;
    solid.mesh.name = filled.mesh.name;
    solid.mesh.positions = filled.mesh.positions;
    solid.patches = filled.patches;
    solid.parts = filled.parts;
    for (uint32_t t = 0; t < filled.size(); ++t) {
        if (!(thickness[filled.part[t]] > 0))
            solid.add(filled.mesh.triangles[t], filled.mesh.corners[t], filled.source[t], filled.patch[t],
                      filled.part[t]);
        else if (filled.source[t] != kNoSource)
            of_patch[filled.patch[t]].push_back(t);
    }
    for (const auto& triangles : of_patch)
        if (!triangles.empty())
            Plate(filled, triangles).addTo(solid, thickness[filled.part[triangles[0]]], solid.parts++);
    filled = std::move(solid);
}

}  // namespace demolish
