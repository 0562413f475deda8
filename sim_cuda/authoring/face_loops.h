// SPDX-License-Identifier: Apache-2.0
// Loops of directed arcs in the plane of a face, and the face parts that they bound (geometry.md 2.4 e-g).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "sim_cuda/authoring/cell_complex.h"
#include "sim_cuda/authoring/face_triangulation.h"

namespace demolish {

/// Faces of some cells, with offsets into arrays of their own.
struct FaceArrays {
    std::vector<ComplexFace> faces;
    std::vector<uint32_t> loop_end;  ///< into loop_vertices
    std::vector<uint32_t> loop_vertices;
    std::vector<std::array<uint32_t, 3>> triangles;
};

struct FaceArc {
    uint32_t from, to;  ///< vertex ids
};

/// Reused from face to face.
class FaceLoops {
  public:
    FaceLoops(const std::vector<Double3>& seeds, const std::vector<ComplexVertex>& vertices)
        : seeds_(seeds), vertices_(vertices) {}

    void clear();
    /// Adds one loop, counter-clockwise seen from cell_b where it bounds solid from outside.
    void addLoop(std::span<const uint32_t> vertex_ids);
    /// Follows arcs to loops; false: some arcs do not close, and no loop was added.
    bool trace(std::vector<FaceArc>& arcs);
    /// Appends one face for every outer loop together with its holes.
    void emit(uint32_t cell_a, uint32_t cell_b, FaceArrays& out);

  private:
    void closeLoop(uint32_t id);
    void project(uint32_t cell_a, uint32_t cell_b);
    size_t outerLoopAround(size_t hole) const;
    void emitPart(uint32_t cell_a, uint32_t cell_b, std::span<const size_t> loops, FaceArrays& out);
    void measure(ComplexFace& face) const;
    bool isConvex(std::span<const size_t> loops) const;

    const std::vector<Double3>& seeds_;
    const std::vector<ComplexVertex>& vertices_;
    std::vector<uint32_t> ids_, start_;  // all loops; start_ holds one past the end
    std::vector<PlanePoint> points_;     // of ids_
    std::vector<double> areas_;          // m^2, by loop
    std::vector<uint32_t> part_ids_, part_start_;
    std::vector<PlanePoint> part_points_;
    Double3 origin_, axis_x_, axis_y_;  // frame of the face's plane
    std::vector<uint32_t> path_;
    std::vector<size_t> around_, part_;
    std::vector<char> is_used_;
    FaceTriangulation triangulation_;
};

}  // namespace demolish
