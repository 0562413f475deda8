// SPDX-License-Identifier: Apache-2.0
#include "tests/bullet/piece_hulls.h"

#include <glm/gtc/quaternion.hpp>
#include <map>

namespace demolish::bullet {
namespace {

glm::dvec3 toGlm(const Double3& v) {
    return {v.x, v.y, v.z};
}
glm::dvec3 toGlm(const Float3& v) {
    return {v.x, v.y, v.z};
}

/// fragment: of the body's cells.
void addBody(const SceneSetup& setup, uint32_t number, std::span<const uint32_t> fragment,
             std::map<uint32_t, Piece>& pieces) {
    const BodyInstance& instance = setup.bodies[number];
    const Quaternion& q = instance.rotation;
    const glm::dquat turn(q.w, q.x, q.y, q.z);
    const auto placed = [&](const glm::dvec3& rest) { return toGlm(instance.position) + turn * rest; };
    const BreakableBody& body = *instance.body;
    for (size_t cell = 0; cell < body.particles.size(); ++cell) {
        const Particle& particle = body.particles[cell];
        Piece& piece = pieces[fragment[cell]];
        const double mass = instance.material.density * particle.volume;
        piece.fragment = fragment[cell];
        piece.body = number;
        piece.mass += mass;
        piece.centre += mass * placed(toGlm(particle.centroid));
        piece.friction = instance.material.friction;
        piece.restitution = instance.material.restitution;
    }
    const FractureGeometry& geometry = body.geometry;
    for (const SurfaceVertex& vertex : geometry.exterior)
        pieces[fragment[vertex.cell]].corners.push_back(placed(toGlm(vertex.position)));
    for (const InteriorFace& face : geometry.faces) {
        const uint32_t a = fragment[face.cell_a], b = fragment[face.cell_b];
        if (a == b) continue;
        for (uint32_t v = face.first_vertex; v < face.first_vertex + face.vertex_count; ++v) {
            const glm::dvec3 corner = placed(toGlm(geometry.pool[geometry.face_vertices[v]]));
            pieces[a].corners.push_back(corner);
            pieces[b].corners.push_back(corner);
        }
    }
}

}  // namespace

std::vector<Piece> piecesOf(const SceneSetup& setup, std::span<const uint32_t> fragment) {
    std::map<uint32_t, Piece> pieces;
    size_t first = 0;
    for (uint32_t body = 0; body < setup.bodies.size(); ++body) {
        const size_t cells = setup.bodies[body].body->particles.size();
        addBody(setup, body, fragment.subspan(first, cells), pieces);
        first += cells;
    }
    std::vector<Piece> list;
    for (auto& [slot, piece] : pieces) {
        piece.centre /= piece.mass;
        for (glm::dvec3& corner : piece.corners) corner -= piece.centre;
        list.push_back(std::move(piece));
    }
    return list;
}

}  // namespace demolish::bullet
