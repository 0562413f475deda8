// SPDX-License-Identifier: Apache-2.0
// The faces of one cell: chains of surface edges on them, winding numbers at their corners (geometry.md 2.4
// b-e).
#pragma once
#include <vector>

#include "sim_cuda/authoring/interior_faces.h"

namespace demolish {

/// Reused from cell to cell.
class CellFaces {
  public:
    explicit CellFaces(const FaceSources& sources)
        : sources_(sources), loops_(sources.seeds, sources.vertices) {}

    /// Appends the faces with higher neighbours to `out`; false: the solid goes on beyond the start cube.
    bool make(uint32_t cell, FaceArrays& out);

  private:
    struct Chain {
        uint32_t face;  // local
        FaceArc arc;
    };
    /// Where the surface crosses a Voronoi edge.
    struct Crossing {
        uint32_t face, across;  // local
        double along;           // order on the way round the face
        int64_t tie;            // the same where two are at one place
        int step;               // of the winding number on that way
        uint32_t vertex;        // id
    };

    bool makeWhole(int winding, FaceArrays& out);
    bool makeCut(FaceArrays& out);
    void collectSurface();
    void addCrossing(uint32_t face, uint32_t across, int step, uint32_t vertex);
    uint32_t faceOf(uint32_t neighbour) const;
    std::span<const Crossing> crossings(uint32_t face, uint32_t across) const;
    void spreadWindings();
    bool spreadRound(uint32_t face);
    void sortFaces();
    void makeFace(uint32_t face, FaceArrays& out);
    void addArc(uint32_t from, uint32_t to, int winding);
    void collectPolygon(uint32_t face);
    std::span<const CellCorner> polygon(uint32_t face) const {
        return view_->corners.subspan(view_->corner_start[face],
                                      view_->corner_start[face + 1] - view_->corner_start[face]);
    }
    uint32_t vertexId(uint32_t local) const { return vertex_ids_[local]; }

    const FaceSources& sources_;
    FaceLoops loops_;
    uint32_t cell_ = 0;
    const VoronoiCell* view_ = nullptr;
    const uint32_t* vertex_ids_ = nullptr;  // by local vertex
    std::vector<Chain> chains_;             // sorted by face
    std::vector<Crossing> crossings_;       // sorted by face, across, along
    std::vector<int> windings_;             // by local vertex
    std::vector<char> is_known_, is_done_;
    std::vector<uint32_t> face_order_;  // faces with higher neighbours, by neighbour
    std::vector<FaceArc> arcs_;
    std::vector<uint32_t> polygon_ids_;
};

}  // namespace demolish
