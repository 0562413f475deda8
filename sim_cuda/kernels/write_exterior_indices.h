// SPDX-License-Identifier: Apache-2.0
// The outside as it is drawn: triangles of the mesh, or the parts of their cells.
#pragma once
#include "sim_cuda/kernels/choose_exterior.h"

namespace demolish {

/// kThreads threads a triangle: those of a coarse mesh are cut into hundreds of parts.
template <uint32_t kThreads>
struct WriteExteriorIndices {
    ExteriorMesh mesh;
    Span<const uint8_t> uncut;
    Span<const uint32_t> first;  ///< of each triangle in the stream, by CountExterior's counts
    Span<uint32_t> out;

    DEM_FN void operator()(uint32_t thread) const {
        const uint32_t t = thread / kThreads, part = thread % kThreads;
        const uint32_t to = first[t];
        if (first[t + 1] > out.size()) return;
        const ExteriorTriangle& triangle = mesh.triangles[t];
        if (uncut[t] == 0) {
            for (uint32_t i = part; i < triangle.index_count; i += kThreads)
                out[to + i] = mesh.parts[triangle.first_index + i];
            return;
        }
        if (part != 0) return;
        const RimView view(mesh, uncut, t);
        const bool cut[3] = {view.points[0] > 2, view.points[1] > 2, view.points[2] > 2};
        const int cut_sides = (cut[0] ? 1 : 0) + (cut[1] ? 1 : 0) + (cut[2] ? 1 : 0);
        for (uint32_t side = 0; side < 3; ++side) {
            // Either the only side with points lies across from the corner where `side` begins, or both sides
            // there have some.
            const bool suits =
                cut_sides == 0 || (cut_sides == 1 ? cut[(side + 1) % 3] : cut[side] && cut[(side + 2) % 3]);
            if (suits) return sew(view, side, to);
        }
    }

  private:
    DEM_FN void add(uint32_t& to, uint32_t u, uint32_t v, uint32_t w) const {
        out[to] = u;
        out[to + 1] = v;
        out[to + 2] = w;
        to += 3;
    }

    /// From the corner where side `a` begins along it and, backwards, along the side before, to the ends of
    /// the side across. Where both have points no triangle lies in one side; where neither has, it is a fan.
    DEM_FN void sew(const RimView& view, uint32_t a, uint32_t to) const {
        const uint32_t across = (a + 1) % 3, c = (a + 2) % 3;
        const uint32_t end_a = view.points[a] - 1, end_c = view.points[c] - 1;
        uint32_t i = end_a > 1 ? 1 : 0, j = end_c > 1 ? 1 : 0;
        if (i == 1) add(to, view.at(a, 0), view.at(a, 1), view.at(c, end_c - 1));
        while (i + 1 < end_a || j + 1 < end_c) {
            if (j + 1 >= end_c || (i + 1 < end_a && (i + 1) * end_c <= (j + 1) * end_a)) {
                add(to, view.at(a, i), view.at(a, i + 1), view.at(c, end_c - j));
                ++i;
            } else {
                add(to, view.at(a, i), view.at(c, end_c - j - 1), view.at(c, end_c - j));
                ++j;
            }
        }
        for (uint32_t k = 0; k + 1 < view.points[across]; ++k)
            add(to, view.at(a, i), view.at(across, k), view.at(across, k + 1));
        if (j > 0) add(to, view.at(a, i), view.at(c, 0), view.at(c, end_c - j));
    }
};

}  // namespace demolish
