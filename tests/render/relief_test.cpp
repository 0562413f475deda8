// SPDX-License-Identifier: Apache-2.0
// Broken faces near the camera have the material's relief: in their outline, the same on both sides of a
// break and in both ways to make a picture, without a hole, and from afar not at all.
#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <vector>

#include "engine/passes/relief_pass.h"
#include "engine/render/mesh_motion.h"
#include "engine/render/noise_volume.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

constexpr float kHeight = 0.03f, kWaves = 0.25f;  // m; cells are 0.3 m wide

class Relief : public GlTest {
  protected:
    static Image withRelief(Scene& scene, float height) {
        scene.view.look.relief_height = height;
        return drawPicture(renderer(), scene);
    }
};

/// Cells of a block, so many along each side, moved as said, each a piece. Breaks are deep but for a rim of
/// 20 cm.
Scene cells(const std::function<glm::vec3(uint32_t, glm::vec3)>& moved, int subdivisions = 2, int along = 3) {
    Scene scene = brokenBlock();
    scene.body = std::make_unique<BlockBody>(BlockOptions{
        .cells = along, .size = 0.9f, .jitter = 0.3f, .subdivisions = subdivisions, .deep = 0.2f});
    scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh());
    const BlockBody& body = *scene.body;
    body.write(
        *scene.mesh, [](uint32_t cell) { return cell; },
        [&](uint32_t slot) { return Motion{.translation = moved(slot, body.cellCentre(slot))}; },
        [](uint32_t, uint32_t) { return false; });
    scene.view.look.relief_height = kHeight;
    scene.view.look.relief_size = kWaves;
    return scene;
}

/// `times` as far from what it looks at.
void moveCamera(Scene& scene, float times) {
    Camera& camera = scene.view.camera;
    camera.eye = camera.target + times * (camera.eye - camera.target);
}

/// Apart from each other, seen from near.
Scene apart(int subdivisions = 2) {
    const glm::vec3 middle(0, 0.45f, 0);
    Scene scene = cells([&](uint32_t, glm::vec3 centre) { return 0.7f * (centre - middle); }, subdivisions);
    moveCamera(scene, 0.6f);
    return scene;
}

/// Bodies are black and what is behind them is white.
void blackOnWhite(Scene& scene) {
    putIntoFurnace(scene.view, glm::vec3(1));
    scene.view.show_floor = false;
    for (float(*colour)[3] : {&scene.view.look.exterior_colour, &scene.view.look.interior_colour})
        for (float& channel : *colour) channel = 0;
}

TEST_F(Relief, OutlinesOfBreaksAreRoughNearTheCamera) {
    Scene scene = apart();
    blackOnWhite(scene);
    const Image flat = withRelief(scene, 0), rough = withRelief(scene, kHeight);
    const size_t changed = differingPixels(flat, rough, 60);
    EXPECT_GT(changed, 400u) << "of outlines of some 2,000 px";
    EXPECT_LT(changed, 8000u);
}

TEST_F(Relief, FromAfarNotABitChanges) {
    Scene scene = apart();
    moveCamera(scene, 9);
    for (const Rasteriser way : {Rasteriser::kDraw, Rasteriser::kCompute}) {
        scene.view.rasteriser = way;
        const Image flat = withRelief(scene, 0);
        EXPECT_EQ(differingPixels(flat, withRelief(scene, kHeight), 0), 0u);
    }
}

TEST_F(Relief, TheOutsideStaysAndNothingOpens) {
    Scene scene = cells([](uint32_t, glm::vec3) { return glm::vec3(0); });
    const Image flat = withRelief(scene, 0);
    EXPECT_LE(differingPixels(flat, withRelief(scene, kHeight), 0), 4u) << "samples on an edge itself";
}

TEST_F(Relief, EachLookHasItsOwn) {
    Scene scene = apart();
    giveHalvesTwoLooks(scene, 0.7f);
    scene.view.more_looks = {scene.view.look};
    scene.view.more_looks[0].relief_height = 0;
    const auto changedAt = [&](bool right) {
        scene.view.more_looks[0].relief_height = right ? kHeight : 0;
        const Image rough = withRelief(scene, right ? 0 : kHeight);
        scene.view.more_looks[0].relief_height = 0;
        return differingPixels(withRelief(scene, 0), rough, 20);
    };
    EXPECT_GT(changedAt(false), 300u);
    EXPECT_GT(changedAt(true), 300u);
}

TEST_F(Relief, DrawnAndComputedItIsTheSame) {
    Scene scene = apart();
    scene.view.rasteriser = Rasteriser::kDraw;
    const Image drawn = withRelief(scene, kHeight);
    scene.view.rasteriser = Rasteriser::kCompute;
    const Image computed = withRelief(scene, kHeight);
    EXPECT_EQ(renderer().refusal(), "");
    const auto pixels = static_cast<double>(drawn.width * drawn.height);
    EXPECT_LE(static_cast<double>(differingPixels(drawn, computed, 5)), 0.005 * pixels);
    EXPECT_LE(static_cast<double>(differingPixels(drawn, computed, 32)), 0.001 * pixels);
    EXPECT_EQ(differingPixels(computed, withRelief(scene, kHeight), 0), 0u) << "the same frame";
    EXPECT_GT(differingPixels(computed, withRelief(scene, 0), 20), 2000u);
}

TEST_F(Relief, WhatIsLeftOutInSoftwareChangesNothing) {
    if (!context().info().software) GTEST_SKIP() << "GPUs draw or compute everything";
    Scene scene = apart();
    scene.view.rasteriser = Rasteriser::kDraw;
    const Image all = withRelief(scene, kHeight);
    scene.view.rasteriser = Rasteriser::kAuto;
    EXPECT_EQ(differingPixels(all, withRelief(scene, kHeight), 0), 0u);
}

/// Broken faces as they are shown, of the cells of a block that lie where they lay.
class NearBlock {
  public:
    /// As it is, lines across faces have 4 steps or 8.
    explicit NearBlock(int along = 3, int subdivisions = 1)
        : scene_(cells([](uint32_t, glm::vec3) { return glm::vec3(0); }, subdivisions, along)) {
        moveCamera(scene_, 2.55f);
        scene_.view.look.relief_size = 1.4f * kWaves;
        const FrameUniforms frame = makeFrameUniforms(scene_.view, 1024);
        const gl::Buffer block = gl::Buffer::immutable(sizeof(frame), &frame);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, block.id());
        const gl::Texture noise = makeNoiseVolume();
        noise.bind(2);
        ReliefPass pass(shaderFolder());
        const NearFaces* near = pass.find(scene_.mesh.get(), scene_.view, frame, false);
        NearFaces::Header header{};
        near->indices.download(std::as_writable_bytes(std::span(&header, 1)));
        indices.resize(header.count);
        if (indices.empty()) throw std::logic_error("nothing is near");
        near->indices.download(std::as_writable_bytes(std::span(indices)), sizeof(header));
        vertices.resize(1 + *std::max_element(indices.begin(), indices.end()));
        near->vertices.download(std::as_writable_bytes(std::span(vertices)));
    }
    size_t triangleCount() const { return indices.size() / 3; }

    std::vector<uint32_t> indices;
    std::vector<MeshVertex> vertices;

  private:
    Scene scene_;
};

using Bits = std::array<uint32_t, 3>;

Bits bitsOf(const MeshVertex& vertex) {
    return {std::bit_cast<uint32_t>(vertex.position.x), std::bit_cast<uint32_t>(vertex.position.y),
            std::bit_cast<uint32_t>(vertex.position.z)};
}

TEST_F(Relief, BothSidesOfABreakAreTheSameToTheBit) {
    const NearBlock block;
    std::map<Bits, std::set<uint32_t>> cells_at;
    for (const uint32_t k : block.indices) cells_at[bitsOf(block.vertices[k])].insert(block.vertices[k].cell);
    EXPECT_GT(cells_at.size(), 1500u);
    for (const auto& [place, of] : cells_at) ASSERT_GE(of.size(), 2u);
}

/// Of each cell how often each edge is there, from one place to the other.
std::map<uint32_t, std::map<std::pair<Bits, Bits>, int>> edgesOfCells(const NearBlock& block) {
    std::map<uint32_t, std::map<std::pair<Bits, Bits>, int>> edges;
    for (size_t i = 0; i + 2 < block.indices.size(); i += 3) {
        const MeshVertex* corners[3];
        for (size_t k = 0; k < 3; ++k) corners[k] = &block.vertices[block.indices[i + k]];
        const Bits at[3] = {bitsOf(*corners[0]), bitsOf(*corners[1]), bitsOf(*corners[2])};
        if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;  // of an edge with fewer steps
        for (size_t k = 0; k < 3; ++k) ++edges[corners[k]->cell][{at[k], at[(k + 1) % 3]}];
    }
    return edges;
}

/// Edges that have no other triangle of the cell on their other side.
size_t openEdges(const std::map<std::pair<Bits, Bits>, int>& edges) {
    return static_cast<size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
        return edge.second != 1 || !edges.contains({edge.first.second, edge.first.first});
    }));
}

/// The middle cell has broken faces all round, of which some are cut into more steps than others.
TEST_F(Relief, TrianglesOfAllSizesMeetWithoutAGap) {
    constexpr uint32_t kMiddle = 13;
    const auto edges = edgesOfCells(NearBlock()).at(kMiddle);
    std::set<Bits> moved;
    for (const auto& [edge, count] : edges) moved.insert(edge.first);
    EXPECT_GT(moved.size(), 150u) << "of 8 corners before";
    EXPECT_EQ(openEdges(edges), 0u) << "of " << edges.size();
}

/// So many that each work group goes through its share in several rounds.
TEST_F(Relief, TwoHundredThousandTrianglesMeetWithoutAGap) {
    constexpr uint32_t kAlong = 13;
    const NearBlock block(kAlong, 3);
    EXPECT_GT(block.triangleCount(), 200000u);
    const auto edges = edgesOfCells(block);
    const auto isInside = [](uint32_t k) { return k > 0 && k + 1 < kAlong; };
    size_t inside = 0, open = 0;
    for (const auto& [cell, of] : edges) {
        if (!isInside(cell % kAlong) || !isInside(cell / kAlong % kAlong) ||
            !isInside(cell / kAlong / kAlong))
            continue;
        ++inside;
        open += openEdges(of);
    }
    EXPECT_EQ(inside, (kAlong - 2) * (kAlong - 2) * (kAlong - 2));
    EXPECT_EQ(open, 0u);
}

TEST_F(Relief, ItIsTheSameEveryTime) {
    const NearBlock first, again;
    EXPECT_GT(first.triangleCount(), 5000u);
    EXPECT_EQ(first.indices, again.indices);
    ASSERT_EQ(first.vertices.size(), again.vertices.size());
    for (size_t k = 0; k < first.vertices.size(); ++k)
        ASSERT_EQ(bitsOf(first.vertices[k]), bitsOf(again.vertices[k]));
}

}  // namespace
}  // namespace demolish::engine::test
