// SPDX-License-Identifier: Apache-2.0
// From a triangle of the mesh to the one below a point near it, over their sides.
#pragma once
#include "sim_cuda/data/outside_mesh.h"

namespace demolish {

/// A triangle of the mesh, and weights of its corners, which sum to 1.
struct MeshPlace {
    uint32_t triangle;
    float weight[3];
};

struct SurfaceWalk {
    static constexpr uint32_t kMostSteps = 64;
    static constexpr float kInside = -1e-4f;  ///< of a weight

    Span<const MeshTriangle> triangles;

    /// The last triangle on the way to `to`, and its weights there; negative where the way ends before: at a
    /// fold, or with `within_chart` where neighbours do not share normals and looks.
    DEM_FN MeshPlace find(uint32_t start, const Vec3<float>& to, bool within_chart) const {
        uint32_t before = kNoNeighbour;
        MeshPlace place{start, {}};
        for (uint32_t step = 0; step < kMostSteps; ++step) {
            if (!weigh(to, place)) return place;
            const uint32_t side = sideTo(place);
            if (side == 3) return place;
            const uint32_t beyond = triangles[place.triangle].neighbour[side];
            if (beyond == kNoNeighbour || beyond == before) return place;
            if (within_chart && !sameChart(triangles[place.triangle], side, triangles[beyond])) return place;
            before = place.triangle;
            place.triangle = beyond;
        }
        weigh(to, place);
        return place;
    }

    /// On the triangle: what is outside of it goes to its rim.
    DEM_FN Vec3<float> pointAt(MeshPlace place) const {
        clampInside(place);
        const MeshTriangle& t = triangles[place.triangle];
        return axpy(place.weight[0], toVec3(t.corner[0]),
                    axpy(place.weight[1], toVec3(t.corner[1]), place.weight[2] * toVec3(t.corner[2])));
    }

    DEM_FN static void clampInside(MeshPlace& place) {
        float sum = 0;
        for (float& weight : place.weight) {
            weight = maxOf(weight, 0.0f);
            sum += weight;
        }
        for (float& weight : place.weight) weight /= sum;
    }

  private:
    /// The side across which to go on; 3: none.
    DEM_FN static uint32_t sideTo(const MeshPlace& place) {
        uint32_t lowest = 0;
        for (uint32_t k = 1; k < 3; ++k) lowest = place.weight[k] < place.weight[lowest] ? k : lowest;
        return place.weight[lowest] < kInside ? (lowest + 1) % 3 : 3;
    }
    /// False, and a corner, where the triangle has no area.
    DEM_FN bool weigh(const Vec3<float>& to, MeshPlace& place) const {
        const MeshTriangle& t = triangles[place.triangle];
        const Vec3<float> a = toVec3(t.corner[0]), ab = toVec3(t.corner[1]) - a, ac = toVec3(t.corner[2]) - a;
        const Vec3<float> normal = cross(ab, ac), from = to - a;
        const float squared = length2(normal);
        const bool has_area = squared > 1e-30f;
        place.weight[1] = has_area ? dot(normal, cross(from, ac)) / squared : 0.0f;
        place.weight[2] = has_area ? dot(normal, cross(ab, from)) / squared : 0.0f;
        place.weight[0] = 1.0f - place.weight[1] - place.weight[2];
        return has_area;
    }
    DEM_FN static bool sameChart(const MeshTriangle& one, uint32_t side, const MeshTriangle& other) {
        for (uint32_t end = 0; end < 2; ++end) {
            const uint32_t corner = (side + end) % 3;
            bool same = false;
            for (uint32_t k = 0; k < 3; ++k)
                same = same || (one.corner[corner] == other.corner[k] &&
                                one.normal[corner] == other.normal[k] && one.chart[corner] == other.chart[k]);
            if (!same) return false;
        }
        return true;
    }
};

}  // namespace demolish
