// SPDX-License-Identifier: Apache-2.0
// The surface that fracture opens: lists by hand on slabs, and invariants on real bodies broken step by step.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <set>

#include "sim_cuda/authoring/body_parts.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "tests/unit/draw/drawn_surface.h"
#include "tests/unit/draw/slab_complex.h"
#include "tests/unit/draw/vertex_unpacking.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish {
namespace {

std::shared_ptr<const BreakableBody> slabs(const std::vector<double>& seed_x) {
    const TriangleMesh mesh = test::makeCube(1);
    const CellComplex complex = test::makeSlabComplex(mesh, seed_x);
    auto body = std::make_shared<BreakableBody>();
    body->particles.resize(seed_x.size());
    for (uint32_t i = 0; i + 1 < seed_x.size(); ++i)
        body->bonds.push_back({i, i + 1, 1.0, {}, {1, 0, 0}, 1.0});
    body->geometry = makeFractureGeometry(mesh, complex, body->bonds);
    body->spacing = std::cbrt(1.0 / static_cast<double>(seed_x.size()));
    return body;
}

std::shared_ptr<const BreakableBody> filled(const TriangleMesh& mesh, uint32_t particles) {
    FillOptions options;
    options.particles = particles;
    return fillWithParticles(SolidMesh(mesh), options);
}

/// Of all pieces together: where the outside slides over the edges of a coarse mesh, other chords bridge
/// them. On models it is below 1e-3 (unit_cracks).
constexpr double kVolumeError = 4e-3;

/// m, at both ends.
std::array<float, 2> widthsOf(const CrackLine& line) {
    return {test::unpackHalf(line.widths & 0xffffu), test::unpackHalf(line.widths >> 16)};
}

/// m, of a crack that does not taper, as it is packed.
float wholeWidth(const test::DrawnSurface& drawn) {
    const float apart = WriteCrackList::kUnfit * static_cast<float>(drawn.spacing());
    return test::unpackHalf(packHalf(test::DrawnSurface::kOpening + apart));
}

double distanceBetween(const Float3& a, const Float3& b) {
    return std::hypot(double(a.x) - b.x, double(a.y) - b.y, double(a.z) - b.z);
}

TEST(FractureSurface, NothingShowsWhileWhole) {
    test::DrawnSurface drawn(test::sceneOf(slabs({-0.3, 0.35})));
    drawn.show({0, 0});
    EXPECT_EQ(drawn.commands.interior.count, 0u);
    EXPECT_EQ(drawn.commands.interior.instance_count, 1u);
    EXPECT_EQ(drawn.commands.cracks.instance_count, 0u);
    EXPECT_EQ(drawn.commands.cracks.count, 6u);
}

TEST(FractureSurface, ABrokenBondInsideOneFragmentShowsItsCrackAndNoFace) {
    test::DrawnSurface drawn(test::sceneOf(slabs({-0.4, -0.1, 0.3})));
    drawn.show({0, 0, 0}, {1});
    EXPECT_EQ(drawn.commands.interior.count, 0u);
    ASSERT_EQ(drawn.commands.cracks.instance_count, 8u);
    const float whole = wholeWidth(drawn);
    for (uint32_t k = 0; k < 8; ++k) {
        const CrackEdge& edge = drawn.scene.geometry.crack_edges[drawn.cracks[k].edge];
        EXPECT_EQ(edge.cell_a, 1u);
        EXPECT_EQ(edge.cell_b, 2u);
        EXPECT_TRUE(k == 0 || drawn.cracks[k - 1].edge < drawn.cracks[k].edge);
        EXPECT_EQ(widthsOf(drawn.cracks[k]), (std::array{whole, whole})) << "it has no end";
    }
    drawn.show({0, 0, 1});  // run through: the crack stays, and the faces appear
    EXPECT_EQ(drawn.commands.cracks.instance_count, 8u);
    EXPECT_EQ(drawn.commands.interior.count, 2u * 8 * 3);
}

TEST(FractureSurface, HairlinesTaperToNothingAtTheirEnds) {
    const auto body = filled(test::makeCube(1), 300);
    std::vector<uint32_t> cracked;  // a crack through one half of the body
    for (uint32_t b = 0; b < body->bonds.size(); ++b) {
        const Double3 a = body->particles[body->bonds[b].i].seed;
        const Double3 c = body->particles[body->bonds[b].j].seed;
        if ((a.x < 0) != (c.x < 0) && std::max(a.y, c.y) < 0) cracked.push_back(b);
    }
    test::DrawnSurface drawn(test::sceneOf(body));
    drawn.show(std::vector<uint32_t>(body->particles.size(), 0), cracked);
    std::map<uint32_t, std::vector<float>> widths;  // of each point, once for each line that leaves it
    for (uint32_t k = 0; k < drawn.commands.cracks.instance_count; ++k) {
        const FractureGeometry& geometry = drawn.scene.geometry;
        const CrackEdge& edge = geometry.crack_edges[drawn.cracks[k].edge];
        const auto [first, second] = widthsOf(drawn.cracks[k]);
        widths[geometry.exterior_home[edge.vertex_0].point].push_back(first);
        widths[geometry.exterior_home[edge.vertex_1].point].push_back(second);
    }
    size_t ends = 0, whole = 0, between = 0;
    const float opening = wholeWidth(drawn);
    for (const auto& [point, wide] : widths) {
        EXPECT_EQ(std::set(wide.begin(), wide.end()).size(), 1u) << "as wide on both sides of a point";
        EXPECT_TRUE(wide.size() != 1 || wide[0] == 0) << "ends in nothing";
        EXPECT_TRUE(wide.size() <= 2 || wide[0] == opening) << "where lines meet";
        ends += wide.size() == 1;
        whole += wide.size() == 2 && wide[0] == opening;
        between += wide[0] > 0 && wide[0] < opening;
    }
    EXPECT_GT(ends, 0u);
    EXPECT_GT(whole, 0u);
    EXPECT_GT(between, 0u);
}

TEST(FractureSurface, TwoHalvesGetOppositeFacesWithTheirNormals) {
    test::DrawnSurface drawn(test::sceneOf(slabs({-0.3, 0.35})));
    drawn.show({0, 1});
    ASSERT_EQ(drawn.commands.interior.count, 2u * 8 * 3);
    const auto total = [](const test::Soup& soup) { return test::enclosedVolume(soup); };
    const std::vector<test::Soup> soups = drawn.soups(2);
    EXPECT_EQ(test::openEdges(soups[0]) + test::openEdges(soups[1]), 0u);
    EXPECT_NEAR(total(soups[0]) + total(soups[1]), 1.0, 1e-6);
    for (uint32_t v = 0; v < 18; ++v) {
        float x, y, z;
        test::unpackOctahedral(drawn.vertices[v].normal, x, y, z);
        EXPECT_EQ(drawn.vertices[v].cell, v < 9 ? 0u : 1u);
        EXPECT_GT(v < 9 ? x : -x, 0.5f) << "outwards of its own half, though the middle is rough";
    }
}

TEST(FractureSurface, BentFragmentsStayClosedAndKeepTheVolumeTogether) {
    for (const uint32_t particles : {40u, 700u}) {
        const auto body = filled(test::makeTorus(0.5, 0.2, 48, 24), particles);
        test::DrawnSurface drawn(test::sceneOf(body));
        const uint32_t fragment_count = particles / 10;
        drawn.show(test::randomFragments(body->geometry, particles, fragment_count, 1));
        ASSERT_GT(drawn.commands.interior.count, 0u);
        double volume = 0;
        for (const test::Soup& soup : drawn.soups(fragment_count)) {
            EXPECT_EQ(test::openEdges(soup), 0u);
            volume += test::enclosedVolume(soup);
        }
        EXPECT_NEAR(volume, body->mesh_volume, kVolumeError * body->mesh_volume);
    }
}

/// Many cells to a triangle of the mesh.
std::shared_ptr<const BreakableBody> coarseBody() {
    return filled(test::makeTorus(0.5, 0.2, 10, 6), 700);
}

TEST(FractureSurface, AWholeBodyIsDrawnByTheTrianglesOfItsMesh) {
    const auto body = coarseBody();
    const SceneSetup setup = test::sceneOf(body);
    test::DrawnSurface drawn(setup);
    drawn.fragments.assign(700, 0);
    drawn.writeStreams();  // before any update
    EXPECT_EQ(drawn.commands.exterior.count, 3 * body->geometry.exterior_triangles.size());
    EXPECT_GT(body->geometry.exterior_indices.size(), 10 * drawn.commands.exterior.count);
    const std::vector<test::Soup> soups = drawn.soups(1);
    EXPECT_EQ(test::openEdges(soups[0]), 0u);
    EXPECT_NEAR(test::enclosedVolume(soups[0]), body->mesh_volume, 1e-6 * body->mesh_volume);
}

TEST(FractureSurface, TrianglesOfTheMeshAreCutWhereTheirCellsParted) {
    const auto body = coarseBody();
    const SceneSetup setup = test::sceneOf(body);
    for (const uint32_t fragment_count : {2u, 9u, 350u}) {
        SCOPED_TRACE(fragment_count);
        test::DrawnSurface drawn(setup);
        drawn.show(test::randomFragments(body->geometry, 700, fragment_count, 5));
        double volume = 0;
        for (const test::Soup& soup : drawn.soups(fragment_count)) {
            EXPECT_EQ(test::openEdges(soup), 0u);
            volume += test::enclosedVolume(soup);
        }
        EXPECT_NEAR(volume, body->mesh_volume, kVolumeError * body->mesh_volume);
        const uint32_t count = drawn.commands.exterior.count;
        EXPECT_LE(count, body->geometry.exterior_indices.size());
        for (uint32_t i = 0; i < count; i += 3) {  // no triangle reaches into another fragment
            const auto slot = [&](uint32_t corner) {
                return drawn.fragments[body->geometry.exterior[drawn.exterior[i + corner]].cell];
            };
            ASSERT_TRUE(slot(0) == slot(1) && slot(1) == slot(2));
        }
        EXPECT_EQ(std::vector(drawn.exterior.begin(), drawn.exterior.begin() + count),
                  drawnExterior(setup, drawn.fragments));
        drawn.surface.reset();
        drawn.fragments.assign(700, 0);
        drawn.writeStreams();
        EXPECT_LT(drawn.commands.exterior.count, count);
    }
}

TEST(FractureSurface, TwoBodiesAreDrawnByTheirOwnTriangles) {
    const auto body = coarseBody();
    SceneSetup setup = test::sceneOf(body);
    setup.bodies.push_back(setup.bodies[0]);
    test::DrawnSurface drawn(setup);
    std::vector<uint32_t> fragment(1400, 0);
    for (uint32_t cell = 700; cell < 1400; ++cell) fragment[cell] = 1 + cell % 2;
    drawn.show(fragment);
    const std::vector<test::Soup> soups = drawn.soups(3);
    for (const test::Soup& soup : soups) EXPECT_EQ(test::openEdges(soup), 0u);
    EXPECT_EQ(soups[0].size(), body->geometry.exterior_triangles.size());
    EXPECT_EQ(std::vector(drawn.exterior.begin(), drawn.exterior.begin() + drawn.commands.exterior.count),
              drawnExterior(setup, fragment));
}

TEST(FractureSurface, NoCellTurnsInsideOutWhenAllComeLoose) {
    const auto body = filled(test::makeSphere(0.5, 4), 600);
    test::DrawnSurface drawn(test::sceneOf(body));
    std::vector<uint32_t> alone(600);
    std::iota(alone.begin(), alone.end(), 0u);
    drawn.show(alone);
    for (const test::Soup& soup : drawn.soups(600)) EXPECT_GT(test::enclosedVolume(soup), 0.0);
}

double areaOf(const test::Soup& soup) {
    double area = 0;
    for (const auto& triangle : soup) {
        const auto side = [&](int k) {
            return Vec3<double>{double(triangle[k].x) - triangle[0].x, double(triangle[k].y) - triangle[0].y,
                                double(triangle[k].z) - triangle[0].z};
        };
        area += 0.5 * length(cross(side(1), side(2)));
    }
    return area;
}

TEST(FractureSurface, ACraterIsNoMouldOfItsCrumbsAndThoseStayWhole) {
    const auto body = filled(test::makeSphere(0.5, 4), 600);
    std::vector<uint32_t> crater(600), alone(600), half(600);  // a half, and the cells of the other one
    std::iota(alone.begin(), alone.end(), 0u);
    uint32_t crumbs = 0;
    for (uint32_t cell = 0; cell < 600; ++cell) {
        half[cell] = body->particles[cell].seed.x < 0 ? 0 : 1;
        crater[cell] = half[cell] == 0 ? 0 : ++crumbs;
    }
    test::DrawnSurface drawn(test::sceneOf(body)), cells(test::sceneOf(body)), halves(test::sceneOf(body));
    drawn.show(crater);
    cells.show(alone);
    halves.show(half);
    const std::vector<test::Soup> pieces = drawn.soups(crumbs + 1), as_cut = cells.soups(600);
    // Between two halves the break is as even as it gets; as cut it has 1.15 of that.
    EXPECT_LT(areaOf(pieces[0]), 1.1 * areaOf(halves.soups(2)[0]));
    for (uint32_t cell = 0; cell < 600; ++cell) {
        if (crater[cell] == 0) continue;
        EXPECT_GT(test::enclosedVolume(pieces[crater[cell]]), 0.2 * test::enclosedVolume(as_cut[cell]));
        EXPECT_EQ(test::openEdges(pieces[crater[cell]]), 0u);
    }
}

TEST(FractureSurface, MovesKeepTheirLimitAndTheOutsideItsShape) {
    const auto body = filled(test::makeVase(50, 30), 700);
    const FractureGeometry& geometry = body->geometry;
    test::DrawnSurface drawn(test::sceneOf(body));
    drawn.show(test::randomFragments(geometry, 700, 60, 2));
    const std::vector<Float3> positions = drawn.positions();
    const double inside = kSmoothingLimit + kRoughness * kRoughnessNoiseBound;
    size_t moved = 0, slid = 0;
    for (size_t v = 0; v < positions.size(); ++v) {
        const double distance = distanceBetween(positions[v], geometry.pool[v]);
        EXPECT_LE(distance, (geometry.pool_on_surface[v] ? 1.0 : inside) * body->spacing);
        moved += distance > 0;
        slid += distance > 0 && geometry.pool_on_surface[v];
    }
    EXPECT_GT(moved, positions.size() / 20);
    EXPECT_GT(slid, geometry.points.size() / 20);
}

TEST(FractureSurface, WhatShowedBeforeNeverMovesAgain) {
    const auto body = filled(test::makeSphere(0.5, 4), 600);
    const FractureGeometry& geometry = body->geometry;
    test::DrawnSurface drawn(test::sceneOf(body));
    std::vector<uint32_t> fragment(600, 0);
    std::vector<bool> shown(geometry.pool.size(), false);
    std::vector<Float3> before = drawn.positions();
    size_t moved_later = 0;
    for (uint32_t stage = 1; stage <= 5; ++stage) {
        const std::vector<uint32_t> finer = test::randomFragments(geometry, 600, 3, stage);
        for (size_t cell = 0; cell < fragment.size(); ++cell)
            fragment[cell] = 3 * fragment[cell] + finer[cell];
        drawn.show(fragment);
        const std::vector<Float3> now = drawn.positions();
        for (size_t v = 0; v < now.size(); ++v) {
            const bool moved = distanceBetween(now[v], before[v]) > 0;
            EXPECT_FALSE(shown[v] && moved);
            moved_later += stage > 1 && moved;
        }
        for (const InteriorFace& face : geometry.faces) {
            if (fragment[face.cell_a] == fragment[face.cell_b]) continue;
            for (uint32_t v = 0; v < face.vertex_count; ++v)
                shown[geometry.face_vertices[face.first_vertex + v]] = true;
        }
        before = now;
    }
    EXPECT_GT(moved_later, 100u);
    drawn.show(fragment);
    const std::vector<Float3> again = drawn.positions();
    EXPECT_EQ(std::memcmp(again.data(), before.data(), again.size() * sizeof(Float3)), 0);
}

TEST(FractureSurface, HairlinesThatCannotBeStraightenedAreNotTriedAgain) {
    const auto body = filled(test::makeVase(50, 30), 700);
    const std::vector<uint32_t> whole(700, 0), parts = test::randomFragments(body->geometry, 700, 60, 2);
    std::vector<uint32_t> cracked;
    for (uint32_t b = 0; b < body->bonds.size(); ++b)
        if (parts[body->bonds[b].i] != parts[body->bonds[b].j]) cracked.push_back(b);
    test::DrawnSurface drawn(test::sceneOf(body));
    drawn.show(whole);
    drawn.show(whole, cracked);
    EXPECT_NE(std::count(drawn.chunks.begin(), drawn.chunks.end(), 1u), 0);
    const std::vector<Float3> before = drawn.positions();
    drawn.show(whole, cracked);
    EXPECT_EQ(std::count(drawn.chunks.begin(), drawn.chunks.end(), 1u), 0) << "nothing is new";
    const std::vector<std::byte> state = drawn.surface.saveState();
    drawn.surface.reset();
    drawn.surface.restoreState(state, drawn.fracture());
    drawn.show(whole, cracked);
    const std::vector<Float3> again = drawn.positions();
    EXPECT_EQ(std::memcmp(again.data(), before.data(), again.size() * sizeof(Float3)), 0);
}

TEST(FractureSurface, OneThreadAndTwoWriteTheSameStreams) {
    const auto body = filled(test::makeTorus(0.5, 0.2, 48, 24), 700);
    std::vector<SurfaceVertex> vertices[2];
    std::vector<uint32_t> indices[2];
    for (const size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        test::DrawnSurface drawn(test::sceneOf(body));
        drawn.show(test::randomFragments(body->geometry, 700, 5, 1));
        drawn.show(test::randomFragments(body->geometry, 700, 40, 2));
        vertices[threads - 1] = drawn.vertices;
        indices[threads - 1] = drawn.indices;
        EXPECT_GT(drawn.commands.interior.count, 0u);
    }
    EXPECT_EQ(indices[0], indices[1]);
    EXPECT_EQ(std::memcmp(vertices[0].data(), vertices[1].data(), vertices[0].size() * sizeof(SurfaceVertex)),
              0);
}

TEST(FractureSurface, ASavedStateComesBackAndAResetIsWhole) {
    const auto body = filled(test::makeSphere(0.5, 3), 300);
    test::DrawnSurface drawn(test::sceneOf(body));
    const std::vector<uint32_t> first = test::randomFragments(body->geometry, 300, 3, 1);
    drawn.show(first);
    const std::vector<SurfaceVertex> vertices = drawn.vertices;
    const std::vector<uint8_t> broken = drawn.broken;
    const uint32_t count = drawn.commands.interior.count;
    const std::vector<std::byte> state = drawn.surface.saveState();

    drawn.show(test::randomFragments(body->geometry, 300, 40, 2));
    ASSERT_NE(drawn.commands.interior.count, count);
    drawn.fragments = first;
    drawn.broken = broken;
    drawn.surface.restoreState(state, drawn.fracture());
    drawn.writeStreams();
    EXPECT_EQ(drawn.commands.interior.count, count);
    EXPECT_EQ(std::memcmp(drawn.vertices.data(), vertices.data(), count / 3 * sizeof(SurfaceVertex)), 0);

    drawn.surface.reset();
    drawn.writeStreams();
    EXPECT_EQ(drawn.commands.interior.count, 0u);
    const std::vector<Float3> positions = drawn.positions();
    EXPECT_EQ(std::memcmp(positions.data(), body->geometry.pool.data(), positions.size() * sizeof(Float3)),
              0);
}

TEST(FractureSurface, BodiesOfASceneAreNumberedThrough) {
    const auto two = slabs({-0.3, 0.35});
    const auto three = slabs({-0.4, -0.1, 0.3});
    SceneSetup setup = test::sceneOf(two);
    setup.bodies.push_back(test::sceneOf(three).bodies[0]);
    test::DrawnSurface drawn(setup);
    drawn.show({0, 0, 1, 1, 2}, {1});  // the second body's first bond is cracked, its second run through
    EXPECT_EQ(drawn.commands.interior.count, 2u * 8 * 3);
    ASSERT_EQ(drawn.commands.cracks.instance_count, 16u);
    for (uint32_t k = 0; k < 16; ++k)
        EXPECT_GE(drawn.scene.geometry.crack_edges[drawn.cracks[k].edge].cell_a, 2u);
    const std::vector<test::Soup> soups = drawn.soups(3);
    const double volumes[] = {1.0, 0.6, 0.4};
    for (int f = 0; f < 3; ++f) {
        EXPECT_EQ(test::openEdges(soups[f]), 0u);
        EXPECT_NEAR(test::enclosedVolume(soups[f]), volumes[f], f == 0 ? 1e-6 : 0.05);
    }
    const FractureGeometry exterior = sceneExterior(setup);
    EXPECT_EQ(exterior.exterior.size(), two->geometry.exterior.size() + three->geometry.exterior.size());
    EXPECT_EQ(exterior.exterior_indices, drawn.scene.geometry.exterior_indices);
    EXPECT_EQ(streamSizes(setup).particles, 5u + kMaxProjectiles);
}

}  // namespace
}  // namespace demolish
