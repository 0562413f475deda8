// SPDX-License-Identifier: Apache-2.0
// Offsets, and nothing but offsets: the geometry of a body is copied with its numbers moved.
#include "sim_cuda/solver/concatenate_geometry.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "sim_cuda/kernels/write_exterior_indices.h"

namespace demolish {
namespace {

/// How much stands before the body that is being added.
struct Offsets {
    uint32_t cell = 0, bond = 0;
};

uint32_t count(const auto& elements) {
    return static_cast<uint32_t>(elements.size());
}

uint32_t movedBond(uint32_t bond, const Offsets& offsets) {
    return bond == kNoBond ? kNoBond : bond + offsets.bond;
}

void append(const std::vector<uint32_t>& from, uint32_t offset, std::vector<uint32_t>& to) {
    to.reserve(to.size() + from.size());
    for (const uint32_t id : from) to.push_back(id + offset);
}

void appendExterior(const FractureGeometry& from, const Offsets& offsets, FractureGeometry& to) {
    const uint32_t first_vertex = count(to.exterior);
    to.exterior.insert(to.exterior.end(), from.exterior.begin(), from.exterior.end());
    const uint32_t first_index = count(to.exterior_indices), first_rim = count(to.exterior_rim);
    const uint32_t first_cell = count(to.exterior_cells), first_triangle = count(to.exterior_triangles);
    for (uint32_t v = first_vertex; v < to.exterior.size(); ++v) {
        to.exterior[v].cell += offsets.cell;
        to.exterior[v].place += first_triangle;
    }
    for (ExteriorTriangle triangle : from.exterior_triangles) {
        triangle.first_index += first_index;
        triangle.first_rim += first_rim;
        for (uint32_t& beyond : triangle.neighbour)
            if (beyond != kNoNeighbour) beyond += first_triangle;
        triangle.first_cell += first_cell;
        to.exterior_triangles.push_back(triangle);
    }
    append(from.exterior_cells, offsets.cell, to.exterior_cells);
    append(from.exterior_indices, first_vertex, to.exterior_indices);
    append(from.exterior_rim, first_vertex, to.exterior_rim);
    for (const CrackEdge& edge : from.crack_edges)
        to.crack_edges.push_back({edge.vertex_0 + first_vertex, edge.vertex_1 + first_vertex,
                                  edge.cell_a + offsets.cell, edge.cell_b + offsets.cell,
                                  movedBond(edge.bond, offsets)});
}

void appendInterior(const FractureGeometry& from, const Offsets& offsets, FractureGeometry& to) {
    const uint32_t first_pool = count(to.pool), first_face = count(to.faces);
    const uint32_t first_vertex = count(to.face_vertices), first_index = count(to.face_indices);
    const uint32_t first_corner = count(to.pool_corner_face);
    for (InteriorFace face : from.faces) {
        face.cell_a += offsets.cell;
        face.cell_b += offsets.cell;
        face.first_vertex += first_vertex;
        face.first_index += first_index;
        face.bond = movedBond(face.bond, offsets);
        to.faces.push_back(face);
    }
    to.pool.insert(to.pool.end(), from.pool.begin(), from.pool.end());
    to.pool_on_surface.insert(to.pool_on_surface.end(), from.pool_on_surface.begin(),
                              from.pool_on_surface.end());
    append(from.face_vertices, first_pool, to.face_vertices);
    to.face_indices.insert(to.face_indices.end(), from.face_indices.begin(), from.face_indices.end());
    for (size_t v = 0; v < from.pool.size(); ++v)
        to.pool_corner_start.push_back(from.pool_corner_start[v + 1] + first_corner);
    append(from.pool_corner_face, first_face, to.pool_corner_face);
    append(from.pool_corner_next, first_pool, to.pool_corner_next);
    append(from.pool_corner_previous, first_pool, to.pool_corner_previous);
}

void appendPoints(const BodyInstance& instance, const Offsets& offsets, FractureGeometry& to) {
    const FractureGeometry& from = instance.body->geometry;
    const auto waves = static_cast<float>(instance.material.break_waves);
    const uint32_t first_point = count(to.points), first_triangle = count(to.mesh_triangles);
    const uint32_t first_pool = count(to.pool), first_edge = count(to.crack_edges);
    const uint32_t first_corner = count(to.point_corner_next), first_crack = count(to.point_cracks);
    for (OutsidePoint point : from.points) {
        point.triangle += first_triangle;
        point.cell += offsets.cell;
        if (point.pool != kNoPool) point.pool += first_pool;
        point.waves = waves * point.spacing;
        to.points.push_back(point);
    }
    for (const ExteriorHome& home : from.exterior_home)
        to.exterior_home.push_back({home.point + first_point, home.triangle + first_triangle});
    for (MeshTriangle triangle : from.mesh_triangles) {
        for (uint32_t& beyond : triangle.neighbour)
            if (beyond != kNoNeighbour) beyond += first_triangle;
        to.mesh_triangles.push_back(triangle);
    }
    for (size_t p = 0; p < from.points.size(); ++p) {
        to.point_corner_start.push_back(from.point_corner_start[p + 1] + first_corner);
        to.point_crack_start.push_back(from.point_crack_start[p + 1] + first_crack);
    }
    append(from.point_corner_next, first_point, to.point_corner_next);
    append(from.point_corner_previous, first_point, to.point_corner_previous);
    for (const PointCrack& crack : from.point_cracks)
        to.point_cracks.push_back({crack.edge + first_edge, crack.other + first_point});
}

Offsets offsetsAfter(const Offsets& offsets, const BreakableBody& body) {
    return {offsets.cell + count(body.particles), offsets.bond + count(body.bonds)};
}

/// Of each pool vertex; where sizes are graded that of the finest cell which it is a corner of.
void appendSpacings(const BreakableBody& body, std::vector<float>& spacings) {
    const FractureGeometry& geometry = body.geometry;
    const size_t first = spacings.size();
    spacings.resize(first + geometry.pool.size(), static_cast<float>(body.spacing));
    if (body.cell_spacing.empty()) return;
    std::fill(spacings.begin() + static_cast<std::ptrdiff_t>(first), spacings.end(),
              std::numeric_limits<float>::max());
    for (const InteriorFace& face : geometry.faces) {
        const double finer = std::min(body.cell_spacing[face.cell_a], body.cell_spacing[face.cell_b]);
        for (uint32_t v = face.first_vertex; v < face.first_vertex + face.vertex_count; ++v) {
            float& spacing = spacings[first + geometry.face_vertices[v]];
            spacing = std::min(spacing, static_cast<float>(finer));
        }
    }
}

}  // namespace

SceneGeometry concatenateGeometry(const std::vector<BodyInstance>& bodies) {
    SceneGeometry scene;
    for (auto* start : {&scene.geometry.pool_corner_start, &scene.geometry.point_corner_start,
                        &scene.geometry.point_crack_start})
        start->push_back(0);
    Offsets offsets;
    for (const BodyInstance& instance : bodies) {
        appendPoints(instance, offsets, scene.geometry);  // before what it counts is appended
        appendExterior(instance.body->geometry, offsets, scene.geometry);
        appendInterior(instance.body->geometry, offsets, scene.geometry);
        appendSpacings(*instance.body, scene.pool_spacing);
        for (size_t v = scene.pool_waves.size(); v < scene.pool_spacing.size(); ++v)
            scene.pool_waves.push_back(static_cast<float>(instance.material.break_waves) *
                                       scene.pool_spacing[v]);
        offsets = offsetsAfter(offsets, *instance.body);
    }
    return scene;
}

FractureGeometry sceneExterior(const SceneSetup& setup) {
    FractureGeometry scene;
    Offsets offsets;
    for (const BodyInstance& instance : setup.bodies) {
        appendExterior(instance.body->geometry, offsets, scene);
        offsets = offsetsAfter(offsets, *instance.body);
    }
    return scene;
}

std::vector<uint32_t> drawnExterior(const SceneSetup& setup, std::span<const uint32_t> particle_fragment) {
    std::vector<uint32_t> drawn;
    uint32_t first_vertex = 0;
    size_t first_cell = 0;
    for (const BodyInstance& instance : setup.bodies) {
        const FractureGeometry& geometry = instance.body->geometry;
        const auto fragment = particle_fragment.subspan(first_cell, instance.body->particles.size());
        const auto triangles = count(geometry.exterior_triangles);
        const auto span = [](const auto& values) { return Span(values.data(), values.size()); };
        const ExteriorMesh mesh{span(geometry.exterior_triangles), span(geometry.exterior_cells),
                                span(geometry.exterior_indices), span(geometry.exterior_rim)};
        std::vector<uint8_t> uncut(triangles);
        std::vector<uint32_t> counts(triangles), first(triangles + 1, 0);
        for (uint32_t t = 0; t < triangles; ++t)
            MarkUncut{mesh, span(fragment), Span(uncut.data(), uncut.size())}(t);
        const Span<const uint8_t> chosen(uncut.data(), uncut.size());
        const CountExterior count_indices{mesh, chosen, Span(counts.data(), counts.size())};
        for (uint32_t t = 0; t < triangles; ++t) {
            count_indices(t);
            first[t + 1] = first[t] + counts[t];
        }
        std::vector<uint32_t> indices(first.back());
        const WriteExteriorIndices<1> write{mesh, chosen, span(std::as_const(first)),
                                            Span(indices.data(), indices.size())};
        for (uint32_t t = 0; t < triangles; ++t) write(t);
        append(indices, first_vertex, drawn);
        first_vertex += count(geometry.exterior);
        first_cell += instance.body->particles.size();
    }
    return drawn;
}

StreamSizes streamSizes(const SceneSetup& setup) {
    StreamSizes sizes;
    sizes.particles = kMaxProjectiles;
    sizes.grains = setup.params.effects.grains;
    sizes.puffs = setup.params.effects.puffs;
    for (const BodyInstance& instance : setup.bodies) {
        const FractureGeometry& geometry = instance.body->geometry;
        sizes.particles += instance.body->particles.size();
        sizes.interior_vertices += 2 * geometry.face_vertices.size();
        sizes.interior_indices += 2 * geometry.face_indices.size();
        sizes.exterior_vertices += geometry.exterior.size();
        sizes.exterior_indices += geometry.exterior_indices.size();
        sizes.crack_edges += geometry.crack_edges.size();
    }
    return sizes;
}

}  // namespace demolish
