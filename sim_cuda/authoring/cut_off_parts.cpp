// SPDX-License-Identifier: Apache-2.0
// Cells are looked through in parallel by union-find over vertex ids; who gets what is settled in order.
#include "sim_cuda/authoring/cut_off_parts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

namespace {

constexpr uint32_t kUnresolved = 0xffffffffu;

/// What bounds each cell: pieces by their order, faces by lists.
struct Borders {
    explicit Borders(const CellComplex& complex)
        : first_piece(complex.seeds.size() + 1, 0), first_face(complex.seeds.size() + 1, 0) {
        const size_t cell_count = complex.seeds.size();
        for (const ExteriorPiece& piece : complex.pieces) ++first_piece[piece.cell + 1];
        for (const ComplexFace& face : complex.faces)
            for (const uint32_t cell : {face.cell_a, face.cell_b}) ++first_face[cell + 1];
        for (size_t cell = 0; cell < cell_count; ++cell) {
            first_piece[cell + 1] += first_piece[cell];
            first_face[cell + 1] += first_face[cell];
        }
        faces.resize(first_face.back());
        std::vector<uint32_t> next(first_face.begin(), first_face.end() - 1);
        for (uint32_t f = 0; f < complex.faces.size(); ++f)
            for (const uint32_t cell : {complex.faces[f].cell_a, complex.faces[f].cell_b})
                faces[next[cell]++] = f;
    }
    std::vector<uint32_t> first_piece, first_face;  ///< by cell, one past the end included
    std::vector<uint32_t> faces;
};

std::span<const uint32_t> loopOf(const CellComplex& complex, const ExteriorPiece& piece) {
    return {complex.exterior_loop.data() + piece.first, piece.count};
}

/// All loops of a face, one after the other: a hole belongs to the part round it.
std::span<const uint32_t> loopsOf(const CellComplex& complex, const ComplexFace& face) {
    const uint32_t begin = complex.loop_start[face.first_loop],
                   end = complex.loop_start[face.first_loop + face.loop_count];
    return {complex.loop_vertices.data() + begin, end - begin};
}

/// Union-find over the vertices of one cell after the other; the arrays are made once.
class VertexSets {
  public:
    explicit VertexSets(size_t vertex_count) : cell_(vertex_count, kNoCell), parent_(vertex_count) {}

    /// Joins what bounds the cell where it shares vertices. Returns the number of separate sets.
    uint32_t join(const CellComplex& complex, const Borders& borders, uint32_t cell) {
        uint32_t sets = 0;
        members_.clear();
        const auto joinAll = [&](std::span<const uint32_t> vertices) {
            for (const uint32_t v : vertices) {
                if (cell_[v] != cell) {
                    cell_[v] = cell;
                    parent_[v] = v;
                    members_.push_back(v);
                    ++sets;
                }
                const uint32_t a = rootOf(v), b = rootOf(vertices[0]);
                sets -= a != b;
                parent_[std::max(a, b)] = std::min(a, b);
            }
        };
        for (uint32_t p = borders.first_piece[cell]; p < borders.first_piece[cell + 1]; ++p)
            joinAll(loopOf(complex, complex.pieces[p]));
        for (uint32_t f = borders.first_face[cell]; f < borders.first_face[cell + 1]; ++f)
            joinAll(loopsOf(complex, complex.faces[borders.faces[f]]));
        return sets;
    }

    /// All that the last join() met, each once.
    const std::vector<uint32_t>& members() const { return members_; }

    /// Lowest vertex of the set, after join() of its cell.
    uint32_t rootOf(uint32_t v) {
        while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }

  private:
    std::vector<uint32_t> cell_, parent_;  // by vertex
    std::vector<uint32_t> members_;
};

struct Part {
    uint32_t cell;
    double volume;   // m^3
    uint32_t owner;  // kUnresolved while it is not known where it goes
    std::map<std::pair<uint32_t, uint32_t>, double> shared;  // m^2, by cell and part beyond; if cut off
};

struct Place {
    uint32_t vertex, part;
};

/// A cell with surface whose border is not connected. Parts are numbered within the cell.
struct SplitCell {
    uint32_t cell;
    std::vector<Part> parts;
    std::vector<Place> places;  // by vertex
};

/// After `sets` has joined the cell. `part_of_root`: by vertex, kUnresolved before and after.
SplitCell partsOf(const CellComplex& complex, const Borders& borders, uint32_t cell, VertexSets& sets,
                  std::vector<uint32_t>& part_of_root) {
    SplitCell split{cell, {}, {}};
    auto& parts = split.parts;
    const Double3 seed = complex.seeds[cell];
    const auto partOf = [&](uint32_t vertex) {
        uint32_t& part = part_of_root[sets.rootOf(vertex)];
        if (part == kUnresolved) {
            part = uint32_t(parts.size());
            parts.push_back({cell, 0, cell, {}});
        }
        return part;
    };
    for (const uint32_t vertex : sets.members()) split.places.push_back({vertex, partOf(vertex)});
    const auto at = [&](uint32_t vertex) { return complex.vertices[vertex].position - seed; };
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c, double sign) {
        parts[partOf(a)].volume += sign * dot(at(a), cross(at(b), at(c))) / 6;
    };
    for (uint32_t p = borders.first_piece[cell]; p < borders.first_piece[cell + 1]; ++p) {
        const auto loop = loopOf(complex, complex.pieces[p]);
        for (size_t k = 2; k < loop.size(); ++k) add(loop[0], loop[k - 1], loop[k], 1);
    }
    for (uint32_t f = borders.first_face[cell]; f < borders.first_face[cell + 1]; ++f) {
        const ComplexFace& face = complex.faces[borders.faces[f]];
        for (uint32_t t = face.first_triangle; t < face.first_triangle + face.triangle_count; ++t) {
            const auto& [a, b, c] = complex.face_triangles[t];
            add(a, b, c, face.cell_a == cell ? 1 : -1);
        }
    }
    const auto main = std::max_element(parts.begin(), parts.end(),
                                       [](const Part& a, const Part& b) { return a.volume < b.volume; });
    for (auto part = parts.begin(); part != parts.end(); ++part)
        if (part != main && part->volume > 0) part->owner = kUnresolved;
    for (const uint32_t vertex : sets.members()) part_of_root[sets.rootOf(vertex)] = kUnresolved;
    std::sort(split.places.begin(), split.places.end(),
              [](const Place& a, const Place& b) { return a.vertex < b.vertex; });
    return split;
}

/// Ascending.
std::vector<SplitCell> findSplitCells(const CellComplex& complex, const Borders& borders) {
    constexpr size_t kBlocks = 8;  // few, for the arrays by vertex are long
    const size_t cell_count = complex.seeds.size();
    std::vector<std::vector<SplitCell>> of_block(kBlocks);
    tbb::parallel_for(size_t(0), kBlocks, [&](size_t block) {
        VertexSets sets(complex.vertices.size());
        std::vector<uint32_t> part_of_root(complex.vertices.size(), kUnresolved);
        const size_t end = (block + 1) * cell_count / kBlocks;
        for (size_t cell = block * cell_count / kBlocks; cell < end; ++cell) {
            if (borders.first_piece[cell] == borders.first_piece[cell + 1]) continue;  // convex
            if (sets.join(complex, borders, uint32_t(cell)) > 1)
                of_block[block].push_back(partsOf(complex, borders, uint32_t(cell), sets, part_of_root));
        }
    });
    std::vector<SplitCell> split;
    for (auto& some : of_block)
        split.insert(split.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
    return split;
}

/// The parts of split cells, and to whom they go.
class CutOffParts {
  public:
    CutOffParts(const CellComplex& complex, std::vector<SplitCell>&& split)
        : complex_(complex), places_of_cell_(complex.seeds.size()) {
        for (SplitCell& cell : split) take(std::move(cell));
        findOwners();
    }

    uint32_t movedCount() const { return moved_; }

    /// The cell that the part of `cell` with this vertex goes to.
    uint32_t ownerAt(uint32_t cell, uint32_t vertex) const {
        const uint32_t part = partAt(cell, vertex);
        return part == kUnresolved ? cell : parts_[part].owner;
    }

  private:
    uint32_t partAt(uint32_t cell, uint32_t vertex) const {
        const auto [begin, end] = places_of_cell_[cell];
        const auto place = std::lower_bound(places_.begin() + begin, places_.begin() + end, vertex,
                                            [](const Place& at, uint32_t v) { return at.vertex < v; });
        return place == places_.begin() + end || place->vertex != vertex ? kUnresolved : place->part;
    }

    void take(SplitCell&& split) {
        const auto first_part = uint32_t(parts_.size());
        const auto first_place = ptrdiff_t(places_.size());
        for (const Place& place : split.places) places_.push_back({place.vertex, first_part + place.part});
        places_of_cell_[split.cell] = {first_place, ptrdiff_t(places_.size())};
        parts_.insert(parts_.end(), std::make_move_iterator(split.parts.begin()),
                      std::make_move_iterator(split.parts.end()));
    }
    void measureSharedAreas();
    void findOwners();
    bool resolveSome(bool only_anchored);

    const CellComplex& complex_;
    std::vector<Part> parts_;
    std::vector<Place> places_;  // of the split cells, cell by cell, by vertex
    std::vector<std::pair<ptrdiff_t, ptrdiff_t>> places_of_cell_;  // into places_, empty where not split
    uint32_t moved_ = 0;
};

void CutOffParts::measureSharedAreas() {
    for (const ComplexFace& face : complex_.faces) {
        const uint32_t vertex = complex_.loop_vertices[complex_.loop_start[face.first_loop]];
        const uint32_t part_a = partAt(face.cell_a, vertex), part_b = partAt(face.cell_b, vertex);
        if (part_a != kUnresolved && parts_[part_a].owner == kUnresolved)
            parts_[part_a].shared[{face.cell_b, part_b}] += face.area;
        if (part_b != kUnresolved && parts_[part_b].owner == kUnresolved)
            parts_[part_b].shared[{face.cell_a, part_a}] += face.area;
    }
}

/// One round. A part goes where its largest neighbour is or went; `only_anchored`: among those neighbours
/// that have a place already, for parts that lean on each other.
bool CutOffParts::resolveSome(bool only_anchored) {
    std::vector<std::pair<uint32_t, uint32_t>> resolved;
    for (uint32_t p = 0; p < parts_.size(); ++p) {
        if (parts_[p].owner != kUnresolved) continue;
        double most = 0;
        uint32_t owner = kUnresolved;
        for (const auto& [beyond, area] : parts_[p].shared) {
            const auto& [cell, part] = beyond;
            const uint32_t place = part == kUnresolved ? cell : parts_[part].owner;
            if (area <= most || (only_anchored && place == kUnresolved)) continue;
            most = area;
            owner = place;
        }
        if (owner != kUnresolved) resolved.emplace_back(p, owner);
    }
    for (const auto& [part, owner] : resolved) parts_[part].owner = owner;
    return !resolved.empty();
}

void CutOffParts::findOwners() {
    measureSharedAreas();
    while (resolveSome(false) || resolveSome(true)) {
    }
    for (Part& part : parts_) {
        if (part.owner == kUnresolved) part.owner = part.cell;
        moved_ += part.owner != part.cell;
    }
}

template <typename Visit>
void forEachInBlocks(size_t count, Visit&& visit) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 1024), [&](const auto& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) visit(i);
    });
}

void relabelPieces(CellComplex& complex, const CutOffParts& parts) {
    forEachInBlocks(complex.pieces.size(), [&](size_t p) {
        ExteriorPiece& piece = complex.pieces[p];
        const uint32_t owner = parts.ownerAt(piece.cell, complex.exterior_loop[piece.first]);
        for (uint32_t k = piece.first; k < piece.first + piece.count; ++k) {
            uint32_t& across = complex.exterior_across[k];
            if (across == kNoCell) continue;
            across = parts.ownerAt(across, complex.exterior_loop[k]);
            if (across == owner) across = kNoCell;
        }
        piece.cell = owner;
    });
    std::stable_sort(complex.pieces.begin(), complex.pieces.end(), [](const auto& a, const auto& b) {
        return std::tie(a.cell, a.triangle) < std::tie(b.cell, b.triangle);
    });
}

/// The other way round: seen from the other cell.
void turnOver(CellComplex& complex, ComplexFace& face) {
    std::swap(face.cell_a, face.cell_b);
    for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l)
        std::reverse(complex.loop_vertices.begin() + complex.loop_start[l],
                     complex.loop_vertices.begin() + complex.loop_start[l + 1]);
    for (uint32_t t = face.first_triangle; t < face.first_triangle + face.triangle_count; ++t)
        std::swap(complex.face_triangles[t][1], complex.face_triangles[t][2]);
}

/// Appends a face of `from` with its loops and triangles.
void appendFace(const CellComplex& from, ComplexFace face, CellComplex& to) {
    const uint32_t loop = face.first_loop, triangle = face.first_triangle;
    face.first_loop = uint32_t(to.loop_start.size() - 1);
    face.first_triangle = uint32_t(to.face_triangles.size());
    for (uint32_t l = loop; l < loop + face.loop_count; ++l) {
        to.loop_vertices.insert(to.loop_vertices.end(), from.loop_vertices.begin() + from.loop_start[l],
                                from.loop_vertices.begin() + from.loop_start[l + 1]);
        to.loop_start.push_back(uint32_t(to.loop_vertices.size()));
    }
    to.face_triangles.insert(to.face_triangles.end(), from.face_triangles.begin() + triangle,
                             from.face_triangles.begin() + triangle + face.triangle_count);
    to.faces.push_back(face);
}

void relabelFaces(CellComplex& complex, const CutOffParts& parts) {
    forEachInBlocks(complex.faces.size(), [&](size_t f) {
        ComplexFace& face = complex.faces[f];
        const uint32_t vertex = complex.loop_vertices[complex.loop_start[face.first_loop]];
        face.cell_a = parts.ownerAt(face.cell_a, vertex);
        face.cell_b = parts.ownerAt(face.cell_b, vertex);
        if (face.cell_a > face.cell_b) turnOver(complex, face);
    });
    std::erase_if(complex.faces, [](const ComplexFace& face) { return face.cell_a == face.cell_b; });
    std::stable_sort(complex.faces.begin(), complex.faces.end(), [](const auto& a, const auto& b) {
        return std::tie(a.cell_a, a.cell_b) < std::tie(b.cell_a, b.cell_b);
    });
    CellComplex kept;
    kept.loop_start.reserve(complex.loop_start.size());
    kept.loop_vertices.reserve(complex.loop_vertices.size());
    kept.face_triangles.reserve(complex.face_triangles.size());
    kept.faces.reserve(complex.faces.size());
    kept.loop_start.push_back(0);
    for (const ComplexFace& face : complex.faces) appendFace(complex, face, kept);
    complex.faces = std::move(kept.faces);
    complex.loop_start = std::move(kept.loop_start);
    complex.loop_vertices = std::move(kept.loop_vertices);
    complex.face_triangles = std::move(kept.face_triangles);
}

}  // namespace

uint32_t moveCutOffParts(CellComplex& complex) {
    const Borders borders(complex);
    std::vector<SplitCell> split = findSplitCells(complex, borders);
    if (split.empty()) return 0;
    const CutOffParts parts(complex, std::move(split));
    if (parts.movedCount() == 0) return 0;
    relabelPieces(complex, parts);
    relabelFaces(complex, parts);
    return parts.movedCount();
}

}  // namespace demolish
