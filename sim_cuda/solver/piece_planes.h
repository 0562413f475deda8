// SPDX-License-Identifier: Apache-2.0
// The planes of all pieces of a few cells (plane_pieces.h), found anew whenever bonds have broken.
#pragma once
#include <algorithm>
#include <vector>

#include "sim_cuda/kernels/plane_pieces.h"
#include "sim_cuda/solver/concatenate_geometry.h"
#include "sim_cuda/solver/outside_surface.h"

namespace demolish {

/// m, of each cell: the mean of the corners of its faces.
inline std::vector<Float3> cellMiddles(const FractureGeometry& geometry) {
    std::vector<Vec3<double>> sum;
    std::vector<double> count;
    for (const InteriorFace& face : geometry.faces)
        for (const uint32_t cell : {face.cell_a, face.cell_b}) {
            if (cell >= sum.size()) {
                sum.resize(cell + 1);
                count.resize(cell + 1);
            }
            for (uint32_t v = 0; v < face.vertex_count; ++v) {
                const Float3& p = geometry.pool[geometry.face_vertices[face.first_vertex + v]];
                sum[cell] = sum[cell] + Vec3<double>{p.x, p.y, p.z};
                count[cell] += 1;
            }
        }
    std::vector<Float3> middles(sum.size());
    for (size_t c = 0; c < sum.size(); ++c)
        if (count[c] > 0)
            middles[c] = {static_cast<float>(sum[c].x / count[c]), static_cast<float>(sum[c].y / count[c]),
                          static_cast<float>(sum[c].z / count[c])};
    return middles;
}

template <class Backend>
class PiecePlanes {
  public:
    /// Keeps a reference to the backend.
    PiecePlanes(Backend& backend, const SceneGeometry& scene)
        : backend_(backend),
          cell_middle_(backend.uploaded(cellMiddles(scene.geometry))),
          sums_(backend.template allocate<uint64_t>(3 * cell_middle_.size())),
          reach_(backend.template allocate<uint32_t>(kPiecePlanes * cell_middle_.size())) {
        constexpr float kUnitsOfSpacing = 1024;
        for (const float h : scene.pool_spacing) unit_ = std::min(unit_, h / kUnitsOfSpacing);
    }

    /// Of pieces with fresh faces (kFaceNew): valid until the next call. `rest`: m, of the pool.
    PieceShapes find(const Fracture& fracture, Span<const InteriorFace> faces,
                     Span<const uint32_t> face_vertices, Span<const uint8_t> face_state,
                     Span<const Float3> rest) {
        const PieceShapes pieces{fracture.fragment, fracture.size, sums_.span(), reach_.span(), unit_};
        backend_.fill(sums_.span(), uint64_t{0});
        backend_.fill(reach_.span(), 0u);
        backend_.forEach(cell_middle_.size(), AddCellMiddles{pieces, cell_middle_.view()},
                         "add cell middles");
        backend_.forEach(faces.size(), SpreadReach{pieces, faces, face_vertices, face_state, rest},
                         "spread reach");
        return pieces;
    }

  private:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;
    Backend& backend_;
    Buffer<Float3> cell_middle_;
    Buffer<uint64_t> sums_;
    Buffer<uint32_t> reach_;
    float unit_ = 1;  ///< m, of the sums
};

}  // namespace demolish
