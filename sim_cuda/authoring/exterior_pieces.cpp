// SPDX-License-Identifier: Apache-2.0
// Triangles are clipped in blocks, in parallel; the pieces are then dealt out to their cells in triangle
// order.
#include "sim_cuda/authoring/exterior_pieces.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "sim_cuda/authoring/triangle_clipper.h"

namespace demolish {

namespace {

constexpr uint32_t kTrianglesPerBlock = 128;

bool isInCube(const Double3& p, const Double3& centre, double half_side) {
    return std::abs(p.x - centre.x) <= half_side && std::abs(p.y - centre.y) <= half_side &&
           std::abs(p.z - centre.z) <= half_side;
}

}  // namespace

struct ExteriorPieces::Block {
    std::vector<ExteriorPiece> pieces;  // first: into the block's own arrays
    std::vector<VertexKey> keys;
    std::vector<Double3> barycentrics;
    std::vector<uint32_t> across;
    std::vector<uint32_t> outgrown;  // cells with a piece that leaves their cube
};

ExteriorPieces::ExteriorPieces(const KeySpace& space, const VoronoiCells& cells)
    : space_(space), cells_(cells) {
    owner_of_vertex_.resize(space.mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, owner_of_vertex_.size(), 256), [&](const auto& range) {
        for (size_t v = range.begin(); v < range.end(); ++v)
            owner_of_vertex_[v] = cells_.grid().nearest(space_.mesh.positions[v]);
    });
}

ExteriorPieces::~ExteriorPieces() = default;

std::vector<uint32_t> ExteriorPieces::cellsWithVerticesBeyondTheirCube() const {
    std::vector<char> is_outgrown(space_.seeds.size(), 0);
    for (size_t v = 0; v < owner_of_vertex_.size(); ++v) {
        const uint32_t cell = owner_of_vertex_[v];
        if (!isInCube(space_.mesh.positions[v], space_.seeds[cell], cells_[cell].half_side))
            is_outgrown[cell] = 1;
    }
    std::vector<uint32_t> cells;
    for (uint32_t cell = 0; cell < is_outgrown.size(); ++cell)
        if (is_outgrown[cell] != 0) cells.push_back(cell);
    return cells;
}

void ExteriorPieces::clip() {
    blocks_.resize((space_.mesh.triangles.size() + kTrianglesPerBlock - 1) / kTrianglesPerBlock);
    tbb::parallel_for(size_t(0), blocks_.size(), [&](size_t block) { clipBlock(block); });
}

void ExteriorPieces::clipBlock(size_t index) {
    auto block = std::make_unique<Block>();
    TriangleClipper clipper(space_, cells_);
    const uint32_t begin = uint32_t(index) * kTrianglesPerBlock;
    const uint32_t end = std::min(begin + kTrianglesPerBlock, uint32_t(space_.mesh.triangles.size()));
    for (uint32_t triangle = begin; triangle < end; ++triangle) {
        const auto& t = space_.mesh.triangles[triangle];
        const std::array<uint32_t, 3> owners{owner_of_vertex_[t[0]], owner_of_vertex_[t[1]],
                                             owner_of_vertex_[t[2]]};
        clipper.clip(
            triangle, owners, [&](uint32_t cell, const std::vector<TriangleClipper::Corner>& corners) {
                block->pieces.push_back(
                    {cell, triangle, uint32_t(block->keys.size()), uint32_t(corners.size())});
                bool is_inside = true;
                for (const TriangleClipper::Corner& corner : corners) {
                    block->keys.push_back(corner.key);
                    block->barycentrics.push_back(corner.barycentrics);
                    block->across.push_back(corner.across);
                    is_inside &= isInCube(corner.position, space_.seeds[cell], cells_[cell].half_side);
                }
                if (!is_inside) block->outgrown.push_back(cell);
            });
    }
    blocks_[index] = std::move(block);
}

std::vector<uint32_t> ExteriorPieces::cellsThatOutgrowTheirCube() const {
    std::vector<uint32_t> cells;
    for (const auto& block : blocks_)
        cells.insert(cells.end(), block->outgrown.begin(), block->outgrown.end());
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

void ExteriorPieces::clipAgain(const std::vector<uint32_t>& cells) {
    tbb::parallel_for(size_t(0), blocks_.size(), [&](size_t block) {
        const auto& pieces = blocks_[block]->pieces;
        if (std::any_of(pieces.begin(), pieces.end(), [&](const ExteriorPiece& piece) {
                return std::binary_search(cells.begin(), cells.end(), piece.cell);
            }))
            clipBlock(block);
    });
}

GatheredPieces ExteriorPieces::gather() const {
    GatheredPieces all;
    std::vector<uint32_t> first_corner(space_.seeds.size() + 1, 0);
    all.cell_start.assign(space_.seeds.size() + 1, 0);
    for (const auto& block : blocks_)
        for (const ExteriorPiece& piece : block->pieces) {
            ++all.cell_start[piece.cell + 1];
            first_corner[piece.cell + 1] += piece.count;
        }
    for (size_t cell = 1; cell < all.cell_start.size(); ++cell) {
        all.cell_start[cell] += all.cell_start[cell - 1];
        first_corner[cell] += first_corner[cell - 1];
    }
    tbb::parallel_invoke([&] { all.keys.resize(first_corner.back()); },  // memory comes page by page
                         [&] { all.barycentrics.resize(first_corner.back()); },
                         [&] {
                             all.pieces.resize(all.cell_start.back());
                             all.across.resize(first_corner.back());
                         });
    std::vector<uint32_t> next_piece(all.cell_start.begin(), all.cell_start.end() - 1);
    std::vector<std::vector<std::pair<uint32_t, uint32_t>>> targets(blocks_.size());  // piece, corner
    for (size_t b = 0; b < blocks_.size(); ++b)
        for (const ExteriorPiece& piece : blocks_[b]->pieces) {
            targets[b].push_back({next_piece[piece.cell]++, first_corner[piece.cell]});
            first_corner[piece.cell] += piece.count;
        }
    tbb::parallel_for(size_t(0), blocks_.size(), [&](size_t b) {
        const Block& block = *blocks_[b];
        for (size_t k = 0; k < block.pieces.size(); ++k) {
            const ExteriorPiece& piece = block.pieces[k];
            const auto [slot, corner] = targets[b][k];
            all.pieces[slot] = {piece.cell, piece.triangle, corner, piece.count};
            std::copy_n(block.keys.begin() + piece.first, piece.count, all.keys.begin() + corner);
            std::copy_n(block.barycentrics.begin() + piece.first, piece.count,
                        all.barycentrics.begin() + corner);
            std::copy_n(block.across.begin() + piece.first, piece.count, all.across.begin() + corner);
        }
    });
    return all;
}

}  // namespace demolish
