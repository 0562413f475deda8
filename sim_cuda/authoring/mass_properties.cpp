// SPDX-License-Identifier: Apache-2.0
// Mass properties of the clipped cells by the divergence theorem: signed tetrahedra from each seed.
#include <tbb/parallel_for.h>

#include <algorithm>

#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/double3.h"

namespace demolish {

namespace {

constexpr size_t kCellsPerBlock = 128;

/// Volume moments of orders 0, 1, 2 about the seed. A tetrahedron (0, a, b, c) of volume v has the second
/// moment v / 20 (aa + bb + cc + ss), s = a + b + c.
class Moments {
  public:
    void addTriangle(const Double3& a, const Double3& b, const Double3& c) {
        const double v = dot(a, cross(b, c)) / 6;
        const Double3 s = a + b + c;
        volume_ += v;
        first_ += s * (v / 4);
        addSquare(a, v / 20);
        addSquare(b, v / 20);
        addSquare(c, v / 20);
        addSquare(s, v / 20);
    }

    /// About the centroid; `seed` is the origin that the triangles were relative to.
    void store(const Double3& seed, Particle& particle) const {
        particle.volume = volume_;
        if (volume_ <= 0) {  // nothing solid to balance
            particle.centroid = seed;
            return;
        }
        const Double3 c = first_ * (1 / volume_);
        particle.centroid = seed + c;
        const SymmetricTensor& m = second_;
        const double xx = m.xx - volume_ * c.x * c.x, yy = m.yy - volume_ * c.y * c.y,
                     zz = m.zz - volume_ * c.z * c.z;
        particle.inertia = {yy + zz,
                            zz + xx,
                            xx + yy,
                            volume_ * c.x * c.y - m.xy,
                            volume_ * c.y * c.z - m.yz,
                            volume_ * c.z * c.x - m.zx};
    }

  private:
    void addSquare(const Double3& p, double weight) {
        second_.xx += weight * p.x * p.x;
        second_.yy += weight * p.y * p.y;
        second_.zz += weight * p.z * p.z;
        second_.xy += weight * p.x * p.y;
        second_.yz += weight * p.y * p.z;
        second_.zx += weight * p.z * p.x;
    }

    double volume_ = 0;
    Double3 first_;
    SymmetricTensor second_;
};

/// Which faces belong to which cell: every face is in the list of both.
struct FacesOfCells {
    explicit FacesOfCells(const CellComplex& complex) : start(complex.seeds.size() + 1, 0) {
        for (const ComplexFace& face : complex.faces) {
            ++start[face.cell_a + 1];
            ++start[face.cell_b + 1];
        }
        for (size_t cell = 1; cell < start.size(); ++cell) start[cell] += start[cell - 1];
        faces.resize(start.back());
        std::vector<uint32_t> next(start.begin(), start.end() - 1);
        for (uint32_t face = 0; face < complex.faces.size(); ++face) {
            faces[next[complex.faces[face].cell_a]++] = face;
            faces[next[complex.faces[face].cell_b]++] = face;
        }
    }
    std::vector<uint32_t> start, faces;
};

/// Calls visit(a, b, c) for every triangle of the cell's surface, outward, relative to its seed.
template <typename Visit>
void forEachTriangle(const CellComplex& complex, const FacesOfCells& faces, uint32_t cell,
                     uint32_t first_piece, Visit&& visit) {
    const Double3 seed = complex.seeds[cell];
    const auto at = [&](uint32_t vertex) { return complex.vertices[vertex].position - seed; };
    for (uint32_t p = first_piece; p < complex.pieces.size() && complex.pieces[p].cell == cell; ++p) {
        const uint32_t* loop = complex.exterior_loop.data() + complex.pieces[p].first;
        for (uint32_t k = 2; k < complex.pieces[p].count; ++k)
            visit(at(loop[0]), at(loop[k - 1]), at(loop[k]));
    }
    for (uint32_t f = faces.start[cell]; f < faces.start[cell + 1]; ++f) {
        const ComplexFace& face = complex.faces[faces.faces[f]];
        for (uint32_t t = face.first_triangle; t < face.first_triangle + face.triangle_count; ++t) {
            const auto& [a, b, c] = complex.face_triangles[t];
            if (face.cell_a == cell)
                visit(at(a), at(b), at(c));
            else
                visit(at(a), at(c), at(b));
        }
    }
}

void weigh(const CellComplex& complex, const FacesOfCells& faces, uint32_t cell, uint32_t first_piece,
           Particle& particle) {
    particle.seed = complex.seeds[cell];
    Moments moments;
    double lowest = 1e300;  // m, relative to the seed
    forEachTriangle(complex, faces, cell, first_piece,
                    [&](const Double3& a, const Double3& b, const Double3& c) {
                        moments.addTriangle(a, b, c);
                        lowest = std::min({lowest, a.y, b.y, c.y});
                    });
    moments.store(particle.seed, particle);
    particle.lowest = lowest < 1e300 ? particle.seed.y + lowest : particle.seed.y;
}

/// Seeds that follow each other mostly lie close together: the last one's depth bounds the search.
double signedDepth(const MeshQueries& queries, const Double3& seed, const Particle* last) {
    constexpr double kRounding = 1 + 1e-9;
    const double bound = last ? (std::abs(last->depth) + length(seed - last->seed)) * kRounding : 1e300;
    const double distance = queries.closestPoint(seed, bound).distance;
    return queries.windingNumber(seed) > 0 ? distance : -distance;
}

}  // namespace

std::vector<Particle> massProperties(const TriangleMesh& mesh, const MeshQueries& queries,
                                     const CellComplex& complex) {
    const FacesOfCells faces(complex);
    std::vector<uint32_t> first_piece(complex.seeds.size(), uint32_t(complex.pieces.size()));
    for (uint32_t p = uint32_t(complex.pieces.size()); p-- > 0;) first_piece[complex.pieces[p].cell] = p;
    double lowest_of_mesh = 1e300;
    for (const Double3& p : mesh.positions) lowest_of_mesh = std::min(lowest_of_mesh, p.y);

    std::vector<Particle> particles(complex.seeds.size());
    const size_t block_count = (particles.size() + kCellsPerBlock - 1) / kCellsPerBlock;
    tbb::parallel_for(size_t(0), block_count, [&](size_t block) {
        const size_t begin = block * kCellsPerBlock, end = std::min(begin + kCellsPerBlock, particles.size());
        for (size_t cell = begin; cell < end; ++cell) {
            Particle& particle = particles[cell];
            weigh(complex, faces, uint32_t(cell), first_piece[cell], particle);
            particle.lowest = std::max(particle.lowest, lowest_of_mesh);  // rounding must not reach below
            particle.depth =
                signedDepth(queries, particle.seed, cell > begin ? &particles[cell - 1] : nullptr);
        }
    });
    return particles;
}

}  // namespace demolish
