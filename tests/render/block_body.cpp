// SPDX-License-Identifier: Apache-2.0
// Cells are deformed cubes that share their corners, so the block is closed whatever the jitter.
#include "tests/render/block_body.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <map>
#include <tuple>

namespace demolish::engine::test {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

float randomUnit(uint32_t h) {
    h = (h ^ 61u ^ (h >> 16)) * 0x9e3779b1u;
    h = (h ^ (h >> 15)) * 0x85ebca77u;
    return static_cast<float>((h ^ (h >> 13)) & 0xffffffu) / 16777216.0f;
}

uint32_t packOctahedral(glm::vec3 n) {
    n /= std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    glm::vec2 p(n.x, n.y);
    if (n.z < 0) {
        p = (1.0f - glm::abs(glm::vec2(n.y, n.x))) *
            glm::vec2(n.x >= 0 ? 1.0f : -1.0f, n.y >= 0 ? 1.0f : -1.0f);
    }
    return glm::packSnorm2x16(p);
}

/// 0 on the outside of a cube .. 1.
float depthOf(glm::vec3 point, const BlockOptions& options) {
    const float half = 0.5f * options.size;
    const float away = half - std::max({std::abs(point.x), std::abs(point.y - half), std::abs(point.z)});
    return options.deep > 0 ? std::clamp(away / options.deep, 0.0f, 1.0f) : 0.0f;
}

}  // namespace

uint32_t BlockBody::cellAt(glm::ivec3 c) const {
    const int n = options_.cells;
    for (int axis = 0; axis < 3; ++axis) {
        if (c[axis] < 0 || c[axis] >= n) return kNone;
    }
    return static_cast<uint32_t>(c.x + n * (c.y + n * c.z));
}

glm::vec3 BlockBody::node(glm::ivec3 n) const {
    const int cells = options_.cells;
    glm::vec3 p(n);
    const uint32_t key = static_cast<uint32_t>(n.x + 64 * (n.y + 64 * n.z)) * 3 + options_.seed * 7919;
    for (int axis = 0; axis < 3; ++axis) {
        const bool border = n[axis] == 0 || n[axis] == cells;  // stays in its side of the block
        if (!border) p[axis] += options_.jitter * (randomUnit(key + static_cast<uint32_t>(axis)) - 0.5f);
    }
    return p * (2.0f / static_cast<float>(cells)) - 1.0f;  // -1..1
}

BlockBody::Face BlockBody::makeFace(glm::ivec3 cell, int axis, int side) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3, m = options_.subdivisions;
    glm::ivec3 neighbour = cell;
    neighbour[axis] += side != 0 ? 1 : -1;
    Face face{cellAt(cell), cellAt(neighbour), axis, side, {}, {}};
    const auto corner = [&](int a, int b) {
        glm::ivec3 n = cell;
        n[axis] += side;
        n[u] += side != 0 ? a : b;  // mirrored on the low side, so that both wind outward
        n[v] += side != 0 ? b : a;
        return node(n);
    };
    for (int j = 0; j <= m; ++j) {
        for (int i = 0; i <= m; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(m),
                        t = static_cast<float>(j) / static_cast<float>(m);
            const glm::vec3 flat =
                glm::mix(glm::mix(corner(0, 0), corner(1, 0), s), glm::mix(corner(0, 1), corner(1, 1), s), t);
            const float largest = std::max({std::abs(flat.x), std::abs(flat.y), std::abs(flat.z)});
            const glm::vec3 ball = glm::length(flat) > 0 ? glm::normalize(flat) * largest : flat;
            const glm::vec3 p = glm::mix(flat, ball, options_.roundness);
            face.points.push_back(0.5f * options_.size * (p + glm::vec3(0, 1, 0)));
        }
    }
    face.normals.assign(face.points.size(), glm::vec3(0));
    const auto at = [&](int i, int j) { return static_cast<size_t>(j * (m + 1) + i); };
    for (int j = 0; j < m; ++j) {
        for (int i = 0; i < m; ++i) {
            const size_t q[4] = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            const glm::vec3 normal =
                glm::cross(face.points[q[2]] - face.points[q[0]], face.points[q[3]] - face.points[q[1]]);
            for (const size_t k : q) face.normals[k] += normal;
        }
    }
    for (glm::vec3& normal : face.normals) normal = glm::normalize(normal);
    return face;
}

void BlockBody::smoothOutside(std::vector<Face>& outside) const {
    using Key = std::tuple<int, int, int, int>;
    const auto keyOf = [&](const Face& face, glm::vec3 p) {
        const glm::ivec3 q(glm::round(p * (4096.0f / options_.size)));
        // A cube keeps its edges: only a rounded block joins normals across sides.
        return Key{options_.roundness > 0.5f ? 0 : face.axis * 2 + face.side + 1, q.x, q.y, q.z};
    };
    std::map<Key, glm::vec3> sums;
    for (const Face& face : outside) {
        for (size_t k = 0; k < face.points.size(); ++k) sums[keyOf(face, face.points[k])] += face.normals[k];
    }
    for (Face& face : outside) {
        for (size_t k = 0; k < face.points.size(); ++k)
            face.normals[k] = glm::normalize(sums[keyOf(face, face.points[k])]);
    }
}

void BlockBody::appendFace(const Face& face, std::vector<Vertex>& vertices,
                           std::vector<uint32_t>& indices) const {
    const auto first = static_cast<uint32_t>(vertices.size());
    const auto m = static_cast<uint32_t>(options_.subdivisions);
    for (size_t k = 0; k < face.points.size(); ++k) {
        const uint32_t depth = glm::packHalf2x16({depthOf(face.points[k], options_), 0});
        vertices.push_back({face.points[k], packOctahedral(face.normals[k]), depth, face.cell});
    }
    for (uint32_t j = 0; j < m; ++j) {
        for (uint32_t i = 0; i < m; ++i) {
            const uint32_t a = first + j * (m + 1) + i, b = a + 1, c = b + m + 1, d = a + m + 1;
            indices.insert(indices.end(), {a, b, c, a, c, d});
        }
    }
}

void BlockBody::appendCrackEdges(const Face& face, uint32_t first_vertex) {
    const int n = options_.cells, m = options_.subdivisions;
    const auto cell = static_cast<int>(face.cell);
    const glm::ivec3 c(cell % n, cell / n % n, cell / (n * n));
    const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
    for (const int along : {u, v}) {  // the far border of the face in each direction, towards the next cell
        glm::ivec3 next = c;
        next[along] += 1;
        const uint32_t other = cellAt(next);
        if (other == kNone) continue;
        const bool far_is_column = (along == u) == (face.side != 0);  // faces of the low side are mirrored
        for (int k = 0; k < m; ++k) {
            const auto vertex = [&](int t) {
                return first_vertex +
                       static_cast<uint32_t>(far_is_column ? t * (m + 1) + m : m * (m + 1) + t);
            };
            const int turned = options_.turned_lines ? 1 : 0;
            crack_edges_.push_back({vertex(k + turned), vertex(k + 1 - turned), face.cell, other, kNone});
        }
    }
}

BlockBody::BlockBody(const BlockOptions& options) : options_(options) {
    std::vector<Face> outside;
    const int n = options_.cells;
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                glm::vec3 centre(0);
                for (int axis = 0; axis < 3; ++axis) {
                    for (int side = 0; side < 2; ++side) {
                        Face face = makeFace({x, y, z}, axis, side);
                        centre += face.points[face.points.size() / 2] / 6.0f;
                        (face.other == kNone ? outside : interior_).push_back(std::move(face));
                    }
                }
                cell_centres_.push_back(centre);
            }
        }
    }
    smoothOutside(outside);
    for (const Face& face : outside) {
        appendCrackEdges(face, static_cast<uint32_t>(exterior_.size()));
        appendFace(face, exterior_, exterior_indices_);
    }
}

FractureMesh BlockBody::makeMesh(std::span<const uint32_t> cell_looks) const {
    static_assert(sizeof(Vertex) == 24 && sizeof(CrackEdge) == 20);
    const size_t face_points = static_cast<size_t>(options_.subdivisions + 1) * (options_.subdivisions + 1);
    const size_t face_indices = size_t{6} * options_.subdivisions * options_.subdivisions;
    FractureMeshData data;
    data.exterior_vertices = std::as_bytes(std::span(exterior_));
    data.exterior_indices = exterior_indices_;
    data.crack_edges = std::as_bytes(std::span(crack_edges_));
    data.cell_looks = cell_looks;
    std::vector<glm::vec4> spheres;
    const float reach = (1 + options_.jitter) * options_.size / static_cast<float>(options_.cells);
    for (const glm::vec3& centre : cell_centres_) spheres.emplace_back(centre, reach);
    data.cell_spheres = spheres;
    data.particle_count = data.particle_capacity = cellCount();
    data.interior_vertex_capacity = interior_.size() * face_points;
    data.interior_index_capacity = interior_.size() * face_indices;
    data.crack_capacity = crack_edges_.size();
    data.grain_capacity = kMostGrains;
    data.puff_capacity = kMostPuffs;
    return FractureMesh(data);
}

void BlockBody::write(FractureMesh& mesh, const std::function<uint32_t(uint32_t)>& slot_of,
                      const std::function<Motion(uint32_t)>& motion_of,
                      const std::function<bool(uint32_t, uint32_t)>& cracked) const {
    struct Transform {
        float rotation[4], translation[3];
        uint32_t age;
    };
    struct Particle {
        glm::vec3 position;
        float radius, value;
        uint32_t fragment, reserved[2];
    };
    std::vector<uint32_t> slots(cellCount()), indices;
    std::vector<CrackLine> cracks;
    std::vector<Transform> transforms(cellCount(), Transform{{0, 0, 0, 1}, {0, 0, 0}, 0});
    std::vector<Particle> particles;
    std::vector<Vertex> vertices;
    for (uint32_t cell = 0; cell < cellCount(); ++cell) {
        slots[cell] = slot_of(cell);
        const Motion m = motion_of(slots[cell]);
        const glm::quat& q = m.rotation;
        transforms[slots[cell]] = {
            {q.x, q.y, q.z, q.w}, {m.translation.x, m.translation.y, m.translation.z}, 1};
        const float radius = 0.5f * options_.size / static_cast<float>(options_.cells);
        const float value = static_cast<float>(cell) / static_cast<float>(cellCount());
        particles.push_back({q * cell_centres_[cell] + m.translation, radius, value, slots[cell], {}});
    }
    for (const Face& face : interior_) {
        if (slots[face.cell] != slots[face.other]) appendFace(face, vertices, indices);
    }
    for (uint32_t k = 0; k < crack_edges_.size(); ++k) {
        const CrackEdge& edge = crack_edges_[k];
        if (cracked(edge.cell_a, edge.cell_b))
            cracks.push_back({k, glm::packHalf2x16(glm::vec2(options_.crack_width))});
    }
    const uint32_t commands[10] = {static_cast<uint32_t>(indices.size()), 1, 0, 0, 0, 6,
                                   static_cast<uint32_t>(cracks.size()),  0, 0, 0};  // the outside stays
    mesh.stream(StreamId::kParticles).upload(std::as_bytes(std::span(particles)));
    mesh.stream(StreamId::kParticleFragment).upload(std::as_bytes(std::span(slots)));
    mesh.stream(StreamId::kTransforms).upload(std::as_bytes(std::span(transforms)));
    mesh.stream(StreamId::kInteriorVertices).upload(std::as_bytes(std::span(vertices)));
    mesh.stream(StreamId::kInteriorIndices).upload(std::as_bytes(std::span(indices)));
    mesh.stream(StreamId::kCrackEdges).upload(std::as_bytes(std::span(cracks)));
    mesh.stream(StreamId::kCommands).upload(std::as_bytes(std::span(commands)));
}

}  // namespace demolish::engine::test
