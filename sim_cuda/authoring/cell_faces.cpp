// SPDX-License-Identifier: Apache-2.0
// Chains, crossings and winding numbers of one cell, joined to arcs and traced.
#include "sim_cuda/authoring/cell_faces.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace demolish {

namespace {

constexpr uint32_t kNoFace = 0xffffffffu;

}  // namespace

bool CellFaces::make(uint32_t cell, FaceArrays& out) {
    cell_ = cell;
    view_ = &sources_.cells[cell];
    vertex_ids_ = sources_.cell_vertex_ids.data() + sources_.cell_vertex_start[cell];
    sortFaces();
    if (sources_.pieces.cell_start[cell] == sources_.pieces.cell_start[cell + 1])
        return makeWhole(sources_.queries.windingNumber(sources_.seeds[cell]), out);
    return makeCut(out);
}

void CellFaces::sortFaces() {
    face_order_.clear();
    for (uint32_t face = 0; face < view_->seed_faces; ++face)
        if (view_->neighbours[face] > cell_) face_order_.push_back(face);
    std::sort(face_order_.begin(), face_order_.end(),
              [&](uint32_t a, uint32_t b) { return view_->neighbours[a] < view_->neighbours[b]; });
}

void CellFaces::collectPolygon(uint32_t face) {
    polygon_ids_.clear();
    for (const CellCorner& corner : polygon(face))
        if (vertexId(corner.vertex) != kNoCell) polygon_ids_.push_back(vertexId(corner.vertex));
}

/// No surface in the cell: each face as often as the solid covers it.
bool CellFaces::makeWhole(int winding, FaceArrays& out) {
    if (winding == 0) return true;
    for (const uint32_t face : face_order_) {
        collectPolygon(face);
        if (polygon_ids_.size() < 3) continue;
        if (winding < 0) std::reverse(polygon_ids_.begin(), polygon_ids_.end());
        loops_.clear();
        for (int copy = 0; copy < std::abs(winding); ++copy) loops_.addLoop(polygon_ids_);
        loops_.emit(cell_, view_->neighbours[face], out);
    }
    return !view_->touchesCube();
}

bool CellFaces::makeCut(FaceArrays& out) {
    collectSurface();
    spreadWindings();
    for (const uint32_t face : face_order_) makeFace(face, out);
    for (size_t v = 0; v < windings_.size(); ++v)
        if (vertexId(uint32_t(v)) == kNoCell && windings_[v] != 0) return false;
    return true;
}

uint32_t CellFaces::faceOf(uint32_t neighbour) const {
    const auto end = view_->neighbours.begin() + view_->seed_faces;
    const auto face = std::find(view_->neighbours.begin(), end, neighbour);
    return face == end ? kNoFace : uint32_t(face - view_->neighbours.begin());
}

void CellFaces::collectSurface() {
    const GatheredPieces& all = sources_.pieces;
    chains_.clear();
    crossings_.clear();
    for (uint32_t p = all.cell_start[cell_]; p < all.cell_start[cell_ + 1]; ++p) {
        const ExteriorPiece& piece = all.pieces[p];
        const uint32_t* across = all.across.data() + piece.first;
        const uint32_t* ids = sources_.corner_ids.data() + piece.first;
        for (uint32_t k = 0; k < piece.count; ++k) {
            if (across[k] == kNoCell) continue;
            const uint32_t face = faceOf(across[k]);
            if (face == kNoFace) continue;
            const uint32_t before = across[k > 0 ? k - 1 : piece.count - 1];
            // The piece's edge reversed bounds the solid on the face.
            chains_.push_back({face, {ids[k + 1 < piece.count ? k + 1 : 0], ids[k]}});
            if (before == kNoCell) continue;
            const uint32_t other = faceOf(before);
            if (other == kNoFace) continue;
            addCrossing(face, other, +1, ids[k]);  // a chain ends here: solid follows on the way round
            addCrossing(other, face, -1, ids[k]);
        }
    }
    std::sort(chains_.begin(), chains_.end(), [](const Chain& a, const Chain& b) { return a.face < b.face; });
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.face, a.across, a.along, a.tie) < std::tie(b.face, b.across, b.along, b.tie);
    });
}

/// The order on the Voronoi edge is by the same numbers in all three cells; only its sense depends on the
/// face. Surfaces that lie on each other cross at one place.
void CellFaces::addCrossing(uint32_t face, uint32_t across, int step, uint32_t vertex) {
    const uint32_t j = view_->neighbours[face], k = view_->neighbours[across];
    std::array<uint32_t, 3> ids{cell_, j, k};
    std::sort(ids.begin(), ids.end());
    const Double3& a = sources_.seeds[ids[0]];
    const Double3 axis = cross(sources_.seeds[ids[1]] - a, sources_.seeds[ids[2]] - a);
    const double along = dot(sources_.vertices[vertex].position - a, axis);
    // Round face j the edge with k runs along (x_j - x_i) x (x_k - x_i).
    const bool is_even = (cell_ < j) + (j < k) + (k < cell_) == 2;
    const int64_t tie = vertex;
    crossings_.push_back({face, across, is_even ? along : -along, is_even ? tie : -tie, step, vertex});
}

std::span<const CellFaces::Crossing> CellFaces::crossings(uint32_t face, uint32_t across) const {
    const auto begin = std::lower_bound(
        crossings_.begin(), crossings_.end(), std::pair(face, across),
        [](const Crossing& c, const auto& key) { return std::pair(c.face, c.across) < key; });
    auto end = begin;
    while (end != crossings_.end() && end->face == face && end->across == across) ++end;
    return {begin, end};
}

/// One ray for one vertex, then along the edges of all faces: the skeleton of a cell is connected.
void CellFaces::spreadWindings() {
    const size_t vertex_count = view_->vertices.size();
    windings_.assign(vertex_count, 0);
    is_known_.assign(vertex_count, 0);
    is_done_.assign(view_->neighbours.size(), 0);
    const Double3 start = vertexId(0) != kNoCell ? sources_.vertices[vertexId(0)].position
                                                 : sources_.seeds[cell_] + view_->positions[0];
    windings_[0] = sources_.queries.windingNumber(start);
    is_known_[0] = 1;
    for (bool is_spreading = true; is_spreading;) {
        is_spreading = false;
        for (uint32_t face = 0; face < view_->neighbours.size(); ++face)
            if (!is_done_[face] && spreadRound(face)) {
                is_done_[face] = 1;
                is_spreading = true;
            }
    }
}

bool CellFaces::spreadRound(uint32_t face) {
    const auto corners = polygon(face);
    size_t first = 0;
    while (first < corners.size() && !is_known_[corners[first].vertex]) ++first;
    if (first == corners.size()) return false;
    int winding = windings_[corners[first].vertex];
    for (size_t step = 0; step + 1 < corners.size(); ++step) {
        const CellCorner& at = corners[(first + step) % corners.size()];
        const CellCorner& next = corners[(first + step + 1) % corners.size()];
        for (const Crossing& crossing : crossings(face, at.across)) winding += crossing.step;
        if (is_known_[next.vertex]) {
            winding = windings_[next.vertex];
        } else {
            windings_[next.vertex] = winding;
            is_known_[next.vertex] = 1;
        }
    }
    return true;
}

void CellFaces::addArc(uint32_t from, uint32_t to, int winding) {
    if (from == kNoCell || to == kNoCell) return;
    for (int copy = 0; copy < std::abs(winding); ++copy)
        arcs_.push_back(winding > 0 ? FaceArc{from, to} : FaceArc{to, from});
}

void CellFaces::makeFace(uint32_t face, FaceArrays& out) {
    arcs_.clear();
    const auto byFace = [](const Chain& chain, uint32_t key) { return chain.face < key; };
    for (auto chain = std::lower_bound(chains_.begin(), chains_.end(), face, byFace);
         chain != chains_.end() && chain->face == face; ++chain)
        arcs_.push_back(chain->arc);
    const auto corners = polygon(face);
    for (size_t k = 0; k < corners.size(); ++k) {
        int winding = windings_[corners[k].vertex];
        uint32_t from = vertexId(corners[k].vertex);
        for (const Crossing& crossing : crossings(face, corners[k].across)) {
            addArc(from, crossing.vertex, winding);
            from = crossing.vertex;
            winding += crossing.step;
        }
        addArc(from, vertexId(corners[k + 1 < corners.size() ? k + 1 : 0].vertex), winding);
    }
    loops_.clear();
    if (!loops_.trace(arcs_)) {  // degenerate seeds: whole, and found unbalanced afterwards
        collectPolygon(face);
        if (polygon_ids_.size() >= 3) loops_.addLoop(polygon_ids_);
    }
    loops_.emit(cell_, view_->neighbours[face], out);
}

}  // namespace demolish
