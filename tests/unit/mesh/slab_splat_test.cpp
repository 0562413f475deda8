// SPDX-License-Identifier: Apache-2.0
// Nearest points where triangles crowd: blocks that know all their nodes pass most triangles over.
#include "sim_cuda/authoring/slab_splat.h"

#include <gtest/gtest.h>

#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/point_triangle.h"

namespace demolish {
namespace {

using Corners = std::array<Double3, 3>;

/// Long and short ones, slender ones among them, all over the frame.
std::vector<Corners> crowd(const NodeFrame& frame, uint32_t count) {
    std::vector<Corners> all;
    for (uint32_t t = 0; t < count; ++t) {
        const auto random = [&](uint64_t stream) { return hashRandomInCube(stream, 0, t); };
        const Double3 whole{(frame.nx - 1) * frame.step, (frame.ny - 1) * frame.step,
                            (frame.nz - 1) * frame.step};
        const Double3 at = random(1),
                      centre{(at.x + 0.5) * whole.x, (at.y + 0.5) * whole.y, (at.z + 0.5) * whole.z};
        const double size = t % 16 == 0 ? 20 * frame.step : 2 * frame.step, width = t % 5 == 0 ? 0.01 : 1;
        const Double3 a = random(2) * size, b = random(3) * size;
        all.push_back({centre, centre + a, centre + a + b * width});
    }
    return all;
}

TEST(SlabSplat, CrowdAgreesWithAllTrianglesAsked) {
    const NodeFrame frame{{0, 0, 0}, 0.1, 27, 21, kSlabLayers};
    const std::vector<Corners> triangles = crowd(frame, 6000);
    std::vector<Nearest> nearest(frame.size());
    SlabSplat splat(frame, {0, kSlabLayers}, nearest);
    for (const Corners& t : triangles) splat.add(t);
    size_t in_band = 0;
    for (int k = 0; k < frame.nz; ++k)
        for (int j = 0; j < frame.ny; ++j)
            for (int i = 0; i < frame.nx; ++i) {
                const Double3 p{i * frame.step, j * frame.step, k * frame.step};
                Nearest wanted;
                for (const auto& [a, b, c] : triangles) {
                    const Double3 q = closestOnTriangle(p, a, b, c);
                    const float squared = float(lengthSquared(p - q));
                    if (squared < wanted.squared) wanted = {float(q.x), float(q.y), float(q.z), squared};
                }
                if (double(wanted.squared) > kBand * kBand * frame.step * frame.step) continue;
                ++in_band;
                const Nearest& got = nearest[frame.index(i, j, k)];
                ASSERT_EQ(got.squared, wanted.squared) << i << ' ' << j << ' ' << k;
                ASSERT_TRUE(got.x == wanted.x && got.y == wanted.y && got.z == wanted.z);
            }
    EXPECT_GT(in_band, frame.size() / 2);
}

}  // namespace
}  // namespace demolish
