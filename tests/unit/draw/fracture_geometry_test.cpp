// SPDX-License-Identifier: Apache-2.0
// Draw data of hand-made slabs: what can be counted and computed on paper.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/double3.h"
#include "tests/unit/draw/fragment_surfaces.h"
#include "tests/unit/draw/slab_complex.h"
#include "tests/unit/draw/vertex_unpacking.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

/// A cube with a texture that is linear in space, so that interpolation has a known answer everywhere.
TriangleMesh texturedCube() {
    TriangleMesh mesh = test::makeCube(1);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const Double3& p = mesh.positions[mesh.triangles[t][corner]];
            mesh.corners[t][corner].uv = {static_cast<float>(0.5 + 0.25 * p.x + 0.125 * p.y),
                                          static_cast<float>(1.0 + p.z - 0.5 * p.x)};
        }
    }
    return mesh;
}

/// As shaders/common/model_looks.glsl finds it.
Float2 uvAt(const FractureGeometry& geometry, const SurfaceVertex& vertex) {
    const MeshTriangle& t = geometry.mesh_triangles[vertex.place];
    const auto point = [](const Float3& p) { return Double3{p.x, p.y, p.z}; };
    const Double3 a = point(t.corner[0]), ab = point(t.corner[1]) - a, ac = point(t.corner[2]) - a;
    const Double3 normal = cross(ab, ac), from = point(vertex.position) - a;
    const double squared = dot(normal, normal);
    const double v = dot(normal, cross(from, ac)) / squared, w = dot(normal, cross(ab, from)) / squared;
    EXPECT_NEAR(dot(from, normal), 0, 1e-6) << "it lies in its triangle";
    const auto& uv = geometry.looks[vertex.place].uv;
    return {static_cast<float>((1 - v - w) * uv[0].x + v * uv[1].x + w * uv[2].x),
            static_cast<float>((1 - v - w) * uv[0].y + v * uv[1].y + w * uv[2].y)};
}

std::vector<BondGeometry> bondsOfSlabs(uint32_t cells) {
    std::vector<BondGeometry> bonds;
    for (uint32_t i = 0; i + 1 < cells; ++i) bonds.push_back({i, i + 1, 1.0, {}, {1, 0, 0}, 1.0});
    return bonds;
}

TEST(FractureGeometry, HalvesOfACubeHaveTheVerticesCountedByHand) {
    const TriangleMesh mesh = texturedCube();
    const CellComplex complex = test::makeSlabComplex(mesh, {-0.3, 0.35});
    const FractureGeometry geometry = makeFractureGeometry(mesh, complex, bondsOfSlabs(2));
    // A half has one whole side (4 corners) and four half sides (2 corners, 2 points on cube edges, 1 on the
    // diagonal).
    EXPECT_EQ(geometry.exterior.size(), 2u * (4 + 4 * 5));
    EXPECT_EQ(geometry.faces.size(), 1u);
    EXPECT_EQ(geometry.faces[0].bond, 0u);
    EXPECT_EQ(geometry.pool.size(), 8u + 1u)
        << "four edges and four diagonals cut, and the centre of the face";
    EXPECT_EQ(geometry.faces[0].index_count, 8u * 3);
    EXPECT_EQ(geometry.pool_corner_face.size(), 8u * 3);
}

TEST(FractureGeometry, CrackEdgesOfTwoHalvesRunRoundTheBodyOnTheLowerSide) {
    const TriangleMesh mesh = texturedCube();
    const CellComplex complex = test::makeSlabComplex(mesh, {-0.3, 0.35});
    const FractureGeometry geometry = makeFractureGeometry(mesh, complex, bondsOfSlabs(2));
    ASSERT_EQ(geometry.crack_edges.size(), 8u);
    double length = 0;
    for (const CrackEdge& crack : geometry.crack_edges) {
        EXPECT_EQ(crack.cell_a, 0u);
        EXPECT_EQ(crack.cell_b, 1u);
        EXPECT_EQ(crack.bond, 0u);
        const SurfaceVertex &u = geometry.exterior[crack.vertex_0], &v = geometry.exterior[crack.vertex_1];
        EXPECT_EQ(u.cell, 0u);
        EXPECT_EQ(v.cell, 0u);
        EXPECT_EQ(u.normal, v.normal);
        EXPECT_FLOAT_EQ(u.position.x, 0.025f);
        EXPECT_FLOAT_EQ(v.position.x, 0.025f);
        length += std::hypot(u.position.y - v.position.y, u.position.z - v.position.z);
    }
    EXPECT_NEAR(length, 4.0, 1e-6);
    EXPECT_EQ(makeFractureGeometry(mesh, complex, {}).crack_edges[0].bond, kNoBond);
}

TEST(FractureGeometry, TextureAndNormalsAreInterpolatedOnACube) {
    TriangleMesh mesh = texturedCube();
    for (auto& corners : mesh.corners)
        for (CornerAttributes& corner : corners) corner.material = 0;
    const CellComplex complex = test::makeSlabComplex(mesh, {-0.45, -0.2, 0.1, 0.43});
    const FractureGeometry geometry = makeFractureGeometry(mesh, complex, bondsOfSlabs(4));
    std::set<uint32_t> cells;
    for (const SurfaceVertex& vertex : geometry.exterior) {
        const Float3& p = vertex.position;
        ASSERT_LT(vertex.place, mesh.triangles.size());
        const Float2 uv = uvAt(geometry, vertex);
        EXPECT_NEAR(uv.x, 0.5 + 0.25 * p.x + 0.125 * p.y, 1e-6) << "to the last digits, however it was cut";
        EXPECT_NEAR(uv.y, 1.0 + p.z - 0.5 * p.x, 1e-6);
        float x, y, z;
        test::unpackOctahedral(vertex.normal, x, y, z);
        EXPECT_NEAR(std::abs(x) + std::abs(y) + std::abs(z), 1, 1e-4);
        EXPECT_NEAR(x * p.x + y * p.y + z * p.z, 0.5, 1e-4)
            << "the normal of the cube's side that the vertex lies on";
        cells.insert(vertex.cell);
    }
    EXPECT_EQ(cells.size(), 4u);
}

TEST(FractureGeometry, VerticesPartWhereMaterialsMeet) {
    TriangleMesh mesh = test::makeCube(1);
    for (auto& corners : mesh.corners)
        for (CornerAttributes& corner : corners) corner.uv = {};
    const CellComplex complex = test::makeSlabComplex(mesh, {-0.3, 0.35});
    const size_t of_one = makeFractureGeometry(mesh, complex, {}).exterior.size();
    EXPECT_EQ(of_one, 2u * (4 + 4 * 5));
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (CornerAttributes& corner : mesh.corners[t]) corner.material = static_cast<uint32_t>(t % 2);
    const FractureGeometry geometry = makeFractureGeometry(mesh, complex, {});
    EXPECT_EQ(geometry.exterior.size(), of_one + 2u * (2 + 4 * 2)) << "two more on each diagonal of a side";
    for (size_t i = 0; i < geometry.exterior_indices.size(); i += 3) {
        const auto material = [&](size_t k) {
            return geometry.looks[geometry.exterior[geometry.exterior_indices[i + k]].place].material;
        };
        EXPECT_EQ(material(0), material(1));
        EXPECT_EQ(material(0), material(2));
    }
}

TEST(FractureGeometry, VerticesPartWhereEitherSetOfUvsDoes) {
    TriangleMesh plain = test::makeCube(1);
    for (auto& corners : plain.corners)
        for (CornerAttributes& corner : corners) corner.uv = {};
    const CellComplex complex = test::makeSlabComplex(plain, {-0.3, 0.35});
    const size_t of_one = makeFractureGeometry(plain, complex, {}).exterior.size();
    for (const auto set : {&CornerAttributes::uv, &CornerAttributes::second_uv}) {
        TriangleMesh mesh = plain;
        for (size_t t = 0; t < mesh.triangles.size(); ++t)
            for (CornerAttributes& corner : mesh.corners[t]) corner.*set = {static_cast<float>(t % 2), 0};
        EXPECT_EQ(makeFractureGeometry(mesh, complex, {}).exterior.size(), of_one + 2u * (2 + 4 * 2));
    }
}

TEST(FractureGeometry, SlabsAreClosedAndHaveTheirVolumes) {
    const TriangleMesh mesh = test::makeCube(1);
    const CellComplex complex = test::makeSlabComplex(mesh, {-0.4, -0.1, 0.3});
    const FractureGeometry geometry = makeFractureGeometry(mesh, complex, bondsOfSlabs(3));
    const std::vector<test::Soup> soups = test::fragmentSurfaces(geometry, {0, 1, 2}, 3, geometry.pool);
    const double volumes[] = {0.25, 0.35, 0.4};
    for (int cell = 0; cell < 3; ++cell) {
        EXPECT_EQ(test::openEdges(soups[cell]), 0u);
        EXPECT_NEAR(test::enclosedVolume(soups[cell]), volumes[cell], 1e-6);
    }
}

TEST(FractureGeometry, CornerListsNameEveryTriangleOnce) {
    const TriangleMesh mesh = test::makeSphere(0.5, 3);
    const CellComplex complex = test::makeSlabComplex(mesh, {-0.3013, 0.0017, 0.2911});
    const FractureGeometry geometry = makeFractureGeometry(mesh, complex, bondsOfSlabs(3));
    ASSERT_EQ(geometry.pool_corner_start.size(), geometry.pool.size() + 1);
    ASSERT_EQ(geometry.pool_corner_start.back(), geometry.face_indices.size());
    std::multiset<std::array<uint32_t, 4>> listed, present;
    for (uint32_t v = 0; v < geometry.pool.size(); ++v)
        for (uint32_t c = geometry.pool_corner_start[v]; c < geometry.pool_corner_start[v + 1]; ++c)
            listed.insert({geometry.pool_corner_face[c], v, geometry.pool_corner_next[c],
                           geometry.pool_corner_previous[c]});
    for (uint32_t f = 0; f < geometry.faces.size(); ++f) {
        const InteriorFace& face = geometry.faces[f];
        for (uint32_t i = 0; i < face.index_count; ++i) {
            const auto at = [&](uint32_t turn) {
                const uint32_t corner = face.first_index + i / 3 * 3 + (i % 3 + turn) % 3;
                return geometry.face_vertices[face.first_vertex + geometry.face_indices[corner]];
            };
            present.insert({f, at(0), at(1), at(2)});
        }
    }
    EXPECT_EQ(listed, present);
}

/// A prism round the x axis with so many sides that one cut has more vertices than 16-bit indices can name.
TriangleMesh manySidedPrism(uint32_t sides) {
    TriangleMesh mesh;
    for (const double x : {-0.5, 0.5})
        for (uint32_t s = 0; s < sides; ++s) {
            const double angle = 2 * std::numbers::pi * s / sides;
            mesh.positions.push_back({x, std::cos(angle), std::sin(angle)});
        }
    mesh.positions.push_back({-0.5, 0, 0});
    mesh.positions.push_back({0.5, 0, 0});
    for (uint32_t s = 0; s < sides; ++s) {
        const uint32_t next = (s + 1) % sides;
        mesh.triangles.push_back({s, sides + next, sides + s});
        mesh.triangles.push_back({s, next, sides + next});
        mesh.triangles.push_back({2 * sides, next, s});
        mesh.triangles.push_back({2 * sides + 1, sides + s, sides + next});
    }
    mesh.corners.resize(mesh.triangles.size());
    return mesh;
}

TEST(FractureGeometry, AFaceTooLargeForShortIndicesIsDrawnAsSeveral) {
    const TriangleMesh mesh = manySidedPrism(40'000);
    ASSERT_NEAR(test::signedVolume(mesh), std::numbers::pi, 1e-6);
    const CellComplex complex = test::makeSlabComplex(mesh, {-0.3, 0.35});
    const FractureGeometry geometry = makeFractureGeometry(mesh, complex, bondsOfSlabs(2));
    ASSERT_EQ(complex.loop_vertices.size(), 80'000u);
    EXPECT_GT(geometry.faces.size(), 1u);
    size_t triangles = 0;
    for (const InteriorFace& face : geometry.faces) {
        EXPECT_LE(face.vertex_count, 65'536u);
        triangles += face.index_count / 3;
    }
    EXPECT_EQ(triangles, 80'000u);
    const std::vector<test::Soup> soups = test::fragmentSurfaces(geometry, {0, 1}, 2, geometry.pool);
    EXPECT_EQ(test::openEdges(soups[0]), 0u);
    EXPECT_NEAR(test::enclosedVolume(soups[0]), 0.525 * std::numbers::pi, 1e-5);
}

}  // namespace
}  // namespace demolish
