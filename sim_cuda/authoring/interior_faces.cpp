// SPDX-License-Identifier: Apache-2.0
// All cells in parallel, in blocks whose faces are strung together in order.
#include "sim_cuda/authoring/interior_faces.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "sim_cuda/authoring/cell_faces.h"

namespace demolish {

namespace {

constexpr size_t kCellsPerBlock = 64;

struct Block {
    FaceArrays arrays;
    std::vector<uint32_t> cut_short;
};

struct Offsets {
    size_t faces = 0, loops = 0, loop_vertices = 0, triangles = 0;
};

void place(const FaceArrays& from, const Offsets& at, FaceArrays& to) {
    for (size_t f = 0; f < from.faces.size(); ++f) {
        ComplexFace face = from.faces[f];
        face.first_loop += uint32_t(at.loops);
        face.first_triangle += uint32_t(at.triangles);
        to.faces[at.faces + f] = face;
    }
    for (size_t l = 0; l < from.loop_end.size(); ++l)
        to.loop_end[at.loops + l] = from.loop_end[l] + uint32_t(at.loop_vertices);
    std::copy(from.loop_vertices.begin(), from.loop_vertices.end(),
              to.loop_vertices.begin() + std::ptrdiff_t(at.loop_vertices));
    std::copy(from.triangles.begin(), from.triangles.end(),
              to.triangles.begin() + std::ptrdiff_t(at.triangles));
}

}  // namespace

InteriorFaces makeInteriorFaces(const FaceSources& sources) {
    const size_t cell_count = sources.cells.size();
    std::vector<Block> blocks((cell_count + kCellsPerBlock - 1) / kCellsPerBlock);
    tbb::parallel_for(size_t(0), blocks.size(), [&](size_t b) {
        CellFaces maker(sources);
        const size_t end = std::min((b + 1) * kCellsPerBlock, cell_count);
        for (size_t cell = b * kCellsPerBlock; cell < end; ++cell)
            if (!maker.make(uint32_t(cell), blocks[b].arrays)) blocks[b].cut_short.push_back(uint32_t(cell));
    });
    std::vector<Offsets> offsets(blocks.size() + 1);
    for (size_t b = 0; b < blocks.size(); ++b) {
        const FaceArrays& arrays = blocks[b].arrays;
        offsets[b + 1] = {offsets[b].faces + arrays.faces.size(), offsets[b].loops + arrays.loop_end.size(),
                          offsets[b].loop_vertices + arrays.loop_vertices.size(),
                          offsets[b].triangles + arrays.triangles.size()};
    }
    InteriorFaces all;
    all.arrays.faces.resize(offsets.back().faces);
    all.arrays.loop_end.resize(offsets.back().loops);
    all.arrays.loop_vertices.resize(offsets.back().loop_vertices);
    all.arrays.triangles.resize(offsets.back().triangles);
    tbb::parallel_for(size_t(0), blocks.size(),
                      [&](size_t b) { place(blocks[b].arrays, offsets[b], all.arrays); });
    for (const Block& block : blocks)
        all.cut_short.insert(all.cut_short.end(), block.cut_short.begin(), block.cut_short.end());
    return all;
}

}  // namespace demolish
