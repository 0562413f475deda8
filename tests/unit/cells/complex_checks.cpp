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
