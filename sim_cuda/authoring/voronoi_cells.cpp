// SPDX-License-Identifier: Apache-2.0
// Each cell is cut by its neighbours, ring by ring, until none can reach it; then its polygons are strung.
#include "sim_cuda/authoring/voronoi_cells.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "sim_cuda/authoring/convex_cell.h"

namespace demolish {

namespace {

constexpr double kStartHalfSide = 1.3;  // h
constexpr size_t kCellsPerBlock = 64;

struct Candidate {
    double distance;  // m^2
    uint32_t id;
    Double3 towards;
};

struct Scratch {
    ConvexCell cell;
    std::vector<Candidate> candidates;
    std::vector<uint16_t> face_of_plane;
    std::vector<uint32_t> plane_order;
    struct Link {
        uint16_t before, vertex, after;  // planes round the face's corner
    };
    std::vector<Link> links;
    std::vector<uint32_t> link_start, link_next;
};

void cutByNeighbours(uint32_t id, const Double3& seed, double half_side, const SeedGrid& grid, Scratch& s) {
    s.cell.reset(half_side);
    const SeedGrid::Place at = grid.placeOf(seed);
    for (int ring = 0;; ring = ring == 0 ? 2 : ring + 1) {
        if (ring > 0 && grid.ringDistance(seed, at, ring) > 2 * s.cell.reach()) return;
        const double reach = 2 * s.cell.reach(), reach_squared = reach * reach;
        s.candidates.clear();
        const auto collect = [&](uint32_t other, const Double3& position) {
            const Double3 towards = position - seed;
            const double distance = lengthSquared(towards);
            if (other != id && distance <= reach_squared) s.candidates.push_back({distance, other, towards});
        };
        grid.visitRing(at, ring, collect);
        if (ring == 0)
            grid.visitRing(at, 1, collect);  // one seed a grid cell: alone, ring 0 is not worth a sort
        std::sort(s.candidates.begin(), s.candidates.end(), [](const Candidate& a, const Candidate& b) {
            return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
        });
        for (const Candidate& candidate : s.candidates) {
            if (candidate.distance > 4 * s.cell.reach() * s.cell.reach()) break;
            s.cell.cut(candidate.towards, candidate.id);
        }
    }
}

}  // namespace

struct VoronoiCells::Block {
    std::vector<uint32_t> neighbours, corner_start;
    std::vector<CellCorner> corners;
    std::vector<std::array<uint32_t, 3>> vertices;
    std::vector<Double3> positions;
    struct Extent {
        size_t faces, starts, corners, vertices;
        double half_side;
        uint32_t seed_faces;
    };
    std::vector<Extent> extents;  // where each cell begins; one more at the end

    void begin(double half_side) {
        extents.push_back(
            {neighbours.size(), corner_start.size(), corners.size(), vertices.size(), half_side, 0});
    }
    void numberFaces(Scratch& s);
    void addPolygons(Scratch& s);
    VoronoiCell view(size_t k) const;
};

/// Faces in use get numbers: neighbours by distance, then the cube.
void VoronoiCells::Block::numberFaces(Scratch& s) {
    const auto& planes = s.cell.planes();
    s.link_start.assign(planes.size() + 1, 0);
    for (const auto& vertex : s.cell.vertices())
        for (const uint16_t plane : vertex.planes) ++s.link_start[plane + 1u];
    s.plane_order.clear();
    for (uint32_t plane = 0; plane < planes.size(); ++plane)
        if (s.link_start[plane + 1] > 0) s.plane_order.push_back(plane);
    std::sort(s.plane_order.begin(), s.plane_order.end(), [&](uint32_t a, uint32_t b) {
        const bool a_cube = planes[a].neighbour == kNoCell, b_cube = planes[b].neighbour == kNoCell;
        if (a_cube != b_cube) return b_cube;
        if (!a_cube && planes[a].offset != planes[b].offset) return planes[a].offset < planes[b].offset;
        return a < b;
    });
    s.face_of_plane.assign(planes.size(), 0);
    for (size_t face = 0; face < s.plane_order.size(); ++face) {
        s.face_of_plane[s.plane_order[face]] = uint16_t(face);
        neighbours.push_back(planes[s.plane_order[face]].neighbour);
        if (neighbours.back() != kNoCell) ++extents.back().seed_faces;
    }
    std::partial_sum(s.link_start.begin(), s.link_start.end(), s.link_start.begin());
}

/// At the corner (a, b, c) the polygon of a comes in along its edge with b and leaves along that with c.
void VoronoiCells::Block::addPolygons(Scratch& s) {
    const auto& cell_vertices = s.cell.vertices();
    s.links.resize(cell_vertices.size() * 3);
    s.link_next.assign(s.link_start.begin(), s.link_start.end() - 1);
    for (size_t v = 0; v < cell_vertices.size(); ++v) {
        const auto& p = cell_vertices[v].planes;
        for (size_t k = 0; k < 3; ++k)
            s.links[s.link_next[p[k]]++] = {p[(k + 1) % 3], uint16_t(v), p[(k + 2) % 3]};
        vertices.push_back({s.cell.planes()[p[0]].neighbour, s.cell.planes()[p[1]].neighbour,
                            s.cell.planes()[p[2]].neighbour});
        positions.push_back(cell_vertices[v].position);
    }
    const size_t first_corner = extents.back().corners;
    for (const uint32_t plane : s.plane_order) {
        corner_start.push_back(uint32_t(corners.size() - first_corner));
        const uint32_t begin = s.link_start[plane], end = s.link_start[plane + 1];
        for (uint32_t placed = begin; placed < end; ++placed) {
            if (placed > begin) {  // bring the corner that follows to this place
                uint32_t follower = placed;
                while (follower < end && s.links[follower].before != s.links[placed - 1].after) ++follower;
                if (follower < end) std::swap(s.links[placed], s.links[follower]);
            }
            corners.push_back({s.links[placed].vertex, s.face_of_plane[s.links[placed].after]});
        }
    }
    corner_start.push_back(uint32_t(corners.size() - first_corner));
}

VoronoiCell VoronoiCells::Block::view(size_t k) const {
    const Extent &from = extents[k], &to = extents[k + 1];
    VoronoiCell cell;
    cell.neighbours = {neighbours.data() + from.faces, to.faces - from.faces};
    cell.corner_start = {corner_start.data() + from.starts, to.starts - from.starts};
    cell.corners = {corners.data() + from.corners, to.corners - from.corners};
    cell.vertices = {vertices.data() + from.vertices, to.vertices - from.vertices};
    cell.positions = {positions.data() + from.vertices, to.vertices - from.vertices};
    cell.half_side = from.half_side;
    cell.seed_faces = from.seed_faces;
    return cell;
}

VoronoiCells::VoronoiCells(const std::vector<Double3>& seeds, double spacing)
    : seeds_(seeds), grid_(seeds, spacing), cells_(seeds.size()) {
    for (VoronoiCell& cell : cells_) cell.half_side = kStartHalfSide * spacing / 2;
    std::vector<uint32_t> all(seeds.size());
    std::iota(all.begin(), all.end(), 0u);
    doubleCubes(all);
}

void VoronoiCells::doubleCubes(const std::vector<uint32_t>& ids) {
    const size_t block_count = (ids.size() + kCellsPerBlock - 1) / kCellsPerBlock, first = blocks_.size();
    blocks_.resize(first + block_count);
    tbb::parallel_for(size_t(0), block_count, [&](size_t b) {
        const size_t begin = b * kCellsPerBlock, end = std::min(begin + kCellsPerBlock, ids.size());
        auto block = std::make_shared<Block>();
        build({ids.data() + begin, end - begin}, *block);
        blocks_[first + b] = std::move(block);
    });
}

void VoronoiCells::build(std::span<const uint32_t> ids, Block& block) {
    thread_local Scratch scratch;
    for (const uint32_t id : ids) {
        const double half_side = 2 * cells_[id].half_side;
        cutByNeighbours(id, seeds_[id], half_side, grid_, scratch);
        block.begin(half_side);
        block.numberFaces(scratch);
        block.addPolygons(scratch);
    }
    block.begin(0);
    for (size_t k = 0; k < ids.size(); ++k) cells_[ids[k]] = block.view(k);
}

}  // namespace demolish
