// SPDX-License-Identifier: Apache-2.0
// Sums over pieces, loops and triangles of a cell complex.
#include "tests/unit/cells/complex_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/hash_random.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {

std::vector<Double3> randomSeeds(const TriangleMesh& mesh, const MeshQueries& queries, uint32_t count,
                                 uint64_t seed) {
    Double3 lower = mesh.positions[0], upper = lower;
    for (const Double3& p : mesh.positions) {
        lower = minimum(lower, p);
        upper = maximum(upper, p);
    }
    std::vector<Double3> seeds;
    for (uint64_t trial = 0; seeds.size() < count; ++trial) {
        const Double3 r = hashRandomInCube(seed, 1, trial) + Double3{0.5, 0.5, 0.5}, size = upper - lower;
        const Double3 p = lower + Double3{r.x * size.x, r.y * size.y, r.z * size.z};
        if (queries.windingNumber(p) > 0) seeds.push_back(p);
    }
    return seeds;
}

double spacingOf(const TriangleMesh& mesh, size_t count) {
    return std::cbrt(signedVolume(mesh) / double(count));
}

double meshArea(const TriangleMesh& mesh) {
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area +=
            0.5 * length(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
    return area;
}

double exteriorArea(const CellComplex& complex) {
    double area = 0;
    for (const ExteriorPiece& piece : complex.pieces) {
        const auto at = [&](uint32_t k) {
            return complex.vertices[complex.exterior_loop[piece.first + k]].position;
        };
        for (uint32_t k = 2; k < piece.count; ++k)
            area += 0.5 * length(cross(at(k - 1) - at(0), at(k) - at(0)));
    }
    return area;
}

std::vector<double> loopVolumes(const CellComplex& complex) {
    std::vector<double> volumes(complex.seeds.size(), 0);
    const auto addFan = [&](uint32_t cell, const uint32_t* ids, uint32_t count, double sign) {
        const auto at = [&](uint32_t k) { return complex.vertices[ids[k]].position - complex.seeds[cell]; };
        for (uint32_t k = 2; k < count; ++k) volumes[cell] += sign * dot(at(0), cross(at(k - 1), at(k))) / 6;
    };
    for (const ExteriorPiece& piece : complex.pieces)
        addFan(piece.cell, complex.exterior_loop.data() + piece.first, piece.count, 1);
    for (const ComplexFace& face : complex.faces)
        for (uint32_t loop = face.first_loop; loop < face.first_loop + face.loop_count; ++loop) {
            const uint32_t begin = complex.loop_start[loop], count = complex.loop_start[loop + 1] - begin;
            addFan(face.cell_a, complex.loop_vertices.data() + begin, count, 1);
            addFan(face.cell_b, complex.loop_vertices.data() + begin, count, -1);
        }
    return volumes;
}

size_t countOpenCells(const CellComplex& complex) {
    const std::vector<uint32_t> unbalanced = unbalancedEdges(complex);
    return size_t(
        std::count_if(unbalanced.begin(), unbalanced.end(), [](uint32_t edges) { return edges > 0; }));
}

namespace {

/// What bounds one cell, outward: vertex ids of each loop, and whether another cell is beyond it.
struct CellBorder {
    std::vector<std::vector<uint32_t>> loops;
    std::vector<char> is_shared;
};

std::vector<CellBorder> bordersOf(const CellComplex& complex) {
    std::vector<CellBorder> borders(complex.seeds.size());
    const auto add = [&](uint32_t cell, const std::vector<uint32_t>& loop, bool is_shared) {
        borders[cell].loops.push_back(loop);
        borders[cell].is_shared.push_back(is_shared);
    };
    for (const ExteriorPiece& piece : complex.pieces) {
        const auto first = complex.exterior_loop.begin() + piece.first;
        add(piece.cell, {first, first + piece.count}, false);
    }
    for (const ComplexFace& face : complex.faces) {
        const auto first = complex.loop_vertices.begin();
        std::vector<uint32_t> all;  // a hole is reached from the loop round it, there and back again
        const uint32_t start = first[complex.loop_start[face.first_loop]];
        for (uint32_t l = face.first_loop; l < face.first_loop + face.loop_count; ++l) {
            all.insert(all.end(), first + complex.loop_start[l], first + complex.loop_start[l + 1]);
            all.insert(all.end(), {first[complex.loop_start[l]], start});
        }
        add(face.cell_a, all, true);
        std::reverse(all.begin(), all.end());
        add(face.cell_b, all, true);
    }
    return borders;
}

size_t countCutOffParts(const CellComplex& complex, const CellBorder& border) {
    std::map<uint32_t, std::vector<size_t>> loops_at;
    for (size_t l = 0; l < border.loops.size(); ++l)
        for (const uint32_t v : border.loops[l]) loops_at[v].push_back(l);
    std::vector<char> is_reached(border.loops.size(), 0);
    size_t parts = 0;
    double largest = 0;
    bool largest_is_shared = false;
    for (size_t first = 0; first < border.loops.size(); ++first) {
        if (is_reached[first] != 0) continue;
        double six_volumes = 0;
        bool is_shared = false;
        std::vector<size_t> front{first};
        is_reached[first] = 1;
        while (!front.empty()) {
            const size_t l = front.back();
            front.pop_back();
            is_shared = is_shared || border.is_shared[l] != 0;
            const auto at = [&](size_t k) { return complex.vertices[border.loops[l][k]].position; };
            for (size_t k = 2; k < border.loops[l].size(); ++k)
                six_volumes += dot(at(0), cross(at(k - 1), at(k)));
            for (const uint32_t v : border.loops[l])
                for (const size_t next : std::exchange(loops_at[v], {}))
                    if (!std::exchange(is_reached[next], 1)) front.push_back(next);
        }
        if (six_volumes <= 0) continue;
        parts += is_shared;
        if (six_volumes > largest) {
            largest = six_volumes;
            largest_is_shared = is_shared;
        }
    }
    return parts - (largest_is_shared ? 1 : 0);
}

}  // namespace

size_t countCutOffParts(const CellComplex& complex) {
    size_t count = 0;
    for (const CellBorder& border : bordersOf(complex)) count += countCutOffParts(complex, border);
    return count;
}

double excessTriangleArea(const CellComplex& complex) {
    double excess = 0;
    for (const ComplexFace& face : complex.faces) {
        double area = 0;
        for (uint32_t t = face.first_triangle; t < face.first_triangle + face.triangle_count; ++t) {
            const auto& [a, b, c] = complex.face_triangles[t];
            const Double3& p = complex.vertices[a].position;
            area += 0.5 * length(cross(complex.vertices[b].position - p, complex.vertices[c].position - p));
        }
        excess += area - face.area;
    }
    return excess;
}

bool triangulationsFitLoops(const CellComplex& complex) {
    for (const ComplexFace& face : complex.faces) {
        std::map<std::pair<uint32_t, uint32_t>, int> balance;
        const auto add = [&](uint32_t from, uint32_t to, int sign) {
            if (from != to) balance[{std::min(from, to), std::max(from, to)}] += from < to ? sign : -sign;
        };
        for (uint32_t t = face.first_triangle; t < face.first_triangle + face.triangle_count; ++t) {
            const auto& triangle = complex.face_triangles[t];
            for (size_t k = 0; k < 3; ++k) add(triangle[k], triangle[(k + 1) % 3], 1);
        }
        for (uint32_t loop = face.first_loop; loop < face.first_loop + face.loop_count; ++loop) {
            const uint32_t begin = complex.loop_start[loop], end = complex.loop_start[loop + 1];
            for (uint32_t k = begin; k < end; ++k)
                add(complex.loop_vertices[k], complex.loop_vertices[k + 1 < end ? k + 1 : begin], -1);
        }
        for (const auto& [edge, sum] : balance)
            if (sum != 0) return false;
    }
    return true;
}

}  // namespace demolish::test
