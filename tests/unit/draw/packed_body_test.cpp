// SPDX-License-Identifier: Apache-2.0
// Draw data of real bodies: fragments of any shape are closed solids of the right volume.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <cstring>
#include <map>
#include <memory>

#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/packing.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "tests/unit/draw/fragment_surfaces.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

std::shared_ptr<const BreakableBody> filled(const TriangleMesh& mesh, uint32_t particles) {
    FillOptions options;
    options.particles = particles;
    return fillWithParticles(SolidMesh(mesh), options);
}

void expectClosedFragments(const BreakableBody& body, uint32_t fragment_count, uint32_t seed) {
    const auto cells = static_cast<uint32_t>(body.particles.size());
    const std::vector<uint32_t> fragment = test::randomFragments(body.geometry, cells, fragment_count, seed);
    const std::vector<test::Soup> soups =
        test::fragmentSurfaces(body.geometry, fragment, fragment_count, body.geometry.pool);
    std::vector<double> volumes(fragment_count, 0);
    for (uint32_t cell = 0; cell < cells; ++cell) volumes[fragment[cell]] += body.particles[cell].volume;
    for (uint32_t f = 0; f < fragment_count; ++f) {
        EXPECT_EQ(test::openEdges(soups[f]), 0u) << "fragment " << f << " of " << fragment_count;
        EXPECT_NEAR(test::enclosedVolume(soups[f]), volumes[f], 1e-6 * body.mesh_volume);
    }
}

TEST(PackedBody, FragmentsAreClosedForAnyLabelling) {
    const std::pair<const char*, TriangleMesh> meshes[] = {{"cube", test::makeCube(1)},
                                                           {"sphere", test::makeSphere(0.5, 4)},
                                                           {"torus", test::makeTorus(0.5, 0.2, 48, 24)},
                                                           {"vase", test::makeVase(50, 30)}};
    for (const auto& [name, mesh] : meshes) {
        for (const uint32_t particles : {7u, 600u}) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(particles));
            const auto body = filled(mesh, particles);
            for (const uint32_t fragments : {1u, 2u, 9u, particles / 2})
                expectClosedFragments(*body, fragments, fragments);
        }
    }
}

TEST(PackedBody, EveryCellAloneIsClosed) {
    const auto body = filled(test::makeVase(50, 30), 400);
    const auto cells = static_cast<uint32_t>(body->particles.size());
    std::vector<uint32_t> alone(cells);
    for (uint32_t cell = 0; cell < cells; ++cell) alone[cell] = cell;
    const std::vector<test::Soup> soups =
        test::fragmentSurfaces(body->geometry, alone, cells, body->geometry.pool);
    for (uint32_t cell = 0; cell < cells; ++cell) {
        EXPECT_EQ(test::openEdges(soups[cell]), 0u) << cell;
        EXPECT_NEAR(test::enclosedVolume(soups[cell]), body->particles[cell].volume,
                    1e-7 * body->mesh_volume);
    }
}

TEST(PackedBody, EdgesInsideAreShortEnoughToBend) {
    const auto body = filled(test::makeTorus(0.5, 0.2, 48, 24), 500);
    const FractureGeometry& geometry = body->geometry;
    std::map<std::pair<uint32_t, uint32_t>, std::pair<uint32_t, uint32_t>>
        faces_of_edge;  // lowest and highest face
    size_t triangles = 0;
    for (uint32_t f = 0; f < geometry.faces.size(); ++f) {
        const InteriorFace& face = geometry.faces[f];
        triangles += face.index_count / 3;
        for (uint32_t i = 0; i < face.index_count; ++i) {
            const auto at = [&](uint32_t corner) {
                return geometry
                    .face_vertices[face.first_vertex + geometry.face_indices[face.first_index + corner]];
            };
            const uint32_t u = at(i), v = at(i / 3 * 3 + (i % 3 + 1) % 3);
            const auto key = std::minmax(u, v);
            const auto [entry, fresh] = faces_of_edge.try_emplace(key, f, f);
            if (!fresh) entry->second.second = f;
        }
    }
    for (const auto& [edge, faces] : faces_of_edge) {
        if (faces.first == faces.second) continue;  // a spoke within one face, or a piece of the outside
        const Float3 &u = geometry.pool[edge.first], &v = geometry.pool[edge.second];
        EXPECT_LE(length(Double3{u.x, u.y, u.z} - Double3{v.x, v.y, v.z}), 0.4501 * body->spacing);
    }
    EXPECT_LT(static_cast<double>(triangles) / static_cast<double>(body->particles.size()), 80.0);
}

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

TEST(PackedBody, OneThreadAndTwoMakeTheSameDrawData) {
    const SolidMesh solid(test::makeVase(50, 30));
    const uint32_t count = 700;
    const double spacing = std::cbrt(solid.info().volume / count);
    const CellComplex complex = buildCellComplex(solid.mesh(), solid.queries(),
                                                 packSeeds(solid.mesh(), solid.queries(), solid.grid(),
                                                           evenSpacing(solid.info().volume, count), count, 3),
                                                 spacing, 3);
    const std::vector<BondGeometry> bonds = makeBonds(complex, spacing);
    FractureGeometry made[2];
    for (const size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        made[threads - 1] = makeFractureGeometry(solid.mesh(), complex, bonds);
    }
    EXPECT_TRUE(sameBytes(made[0].exterior, made[1].exterior));
    EXPECT_TRUE(sameBytes(made[0].exterior_indices, made[1].exterior_indices));
    EXPECT_TRUE(sameBytes(made[0].exterior_rim, made[1].exterior_rim));
    EXPECT_TRUE(sameBytes(made[0].exterior_triangles, made[1].exterior_triangles));
    EXPECT_TRUE(sameBytes(made[0].pool, made[1].pool));
    EXPECT_TRUE(sameBytes(made[0].pool_on_surface, made[1].pool_on_surface));
    EXPECT_TRUE(sameBytes(made[0].faces, made[1].faces));
    EXPECT_TRUE(sameBytes(made[0].face_vertices, made[1].face_vertices));
    EXPECT_TRUE(sameBytes(made[0].face_indices, made[1].face_indices));
    EXPECT_TRUE(sameBytes(made[0].pool_corner_start, made[1].pool_corner_start));
    EXPECT_TRUE(sameBytes(made[0].pool_corner_face, made[1].pool_corner_face));
    EXPECT_TRUE(sameBytes(made[0].pool_corner_next, made[1].pool_corner_next));
    EXPECT_TRUE(sameBytes(made[0].pool_corner_previous, made[1].pool_corner_previous));
    EXPECT_TRUE(sameBytes(made[0].crack_edges, made[1].crack_edges));
}

}  // namespace
}  // namespace demolish
