// SPDX-License-Identifier: Apache-2.0
// What must be true of cracks on every driver: drawn when listed, as wide as they say, dark by depth, lit
// walls.
#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "engine/image/compare.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

class Cracks : public GlTest {};

TEST_F(Cracks, AreDrawnWhenListedAndOnlyThen) {
    Scene cracked = makeScene("cracked_block");
    const Image with = drawPicture(renderer(), cracked);
    cracked.view.show_cracks = false;
    const Image without = drawPicture(renderer(), cracked);
    EXPECT_GT(differingPixels(with, without, 40), 300u);
    const Scene whole = wholeBlock();
    EXPECT_EQ(differingPixels(drawPicture(renderer(), whole), without, 0), 0u);
}

TEST_F(Cracks, LieOnTheBody) {
    Scene cracked = makeScene("cracked_block");
    const std::vector<uint32_t> ids =
        renderer().fragmentIds(cracked.mesh.get(), cracked.spheres, cracked.view);
    const Image with = drawPicture(renderer(), cracked);
    cracked.view.show_cracks = false;
    const Image without = drawPicture(renderer(), cracked);
    size_t outside = 0;
    for (size_t i = 0; i < ids.size(); ++i) {
        const bool crack = std::abs(with.pixels[4 * i + 1] - without.pixels[4 * i + 1]) > 40;
        outside += crack && !isBody(ids[i]);
    }
    EXPECT_LT(outside, 40u);  // pixels on the outline belong half to the body
}

/// A crack down the middle of a white face, 200 px a metre. `aside`: rad, by which one looks from the left;
/// `look`: of all cells.
Scene crackedFace(const BlockOptions& block, float aside = 0, uint32_t look = 0) {
    Scene scene = wholeBlock();
    scene.body = std::make_unique<BlockBody>(block);
    const std::vector<uint32_t> looks(8, look);
    scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh(looks));
    const auto isLeft = [&](uint32_t cell) { return scene.body->cellCentre(cell).z > 0; };
    scene.body->write(
        *scene.mesh, [](uint32_t) { return 0u; }, [](uint32_t) { return Motion{}; },
        [&](uint32_t a, uint32_t b) { return isLeft(a) != isLeft(b); });
    putIntoFurnace(scene.view, glm::vec3(0.8f));
    scene.view.look.noise_strength = 0;
    scene.view.look.crack_width = 0.05f;  // of the widest
    std::ranges::fill(scene.view.look.exterior_colour, 0.8f);
    scene.view.look.exterior_roughness = 1;
    scene.view.width = scene.view.height = 200;
    scene.view.camera.target = {0.5f, 0.5f, 0};
    scene.view.camera.eye = scene.view.camera.target + 20.0f * glm::vec3(std::cos(aside), 0, std::sin(aside));
    scene.view.camera.field_of_view = 2 * std::atan(0.5f / 20);
    return scene;
}
Scene crackedFace(float opening, float aside, uint32_t look = 0) {
    return crackedFace(BlockOptions{.cells = 2, .crack_width = opening}, aside, look);
}

/// Of each column of pixels across that crack what share of its light is gone, mean of 40 rows.
std::vector<float> hiddenAcross(Renderer& renderer, float opening, float aside = 0) {
    Scene scene = crackedFace(opening, aside);
    const Image with = drawPicture(renderer, scene);
    scene.view.show_cracks = false;
    const Image without = drawPicture(renderer, scene);
    std::vector<float> hidden;
    for (int x = 60; x < 140; ++x) {  // what is blended is the root of the albedo
        hidden.push_back(0);
        for (int y = 20; y < 60; ++y)
            hidden.back() += (1 - std::sqrt(decoded(with.at(x, y)[1]) / decoded(without.at(x, y)[1]))) / 40;
    }
    return hidden;
}

/// In whole pixels of the crack's inside.
float pixelsHidden(Renderer& renderer, float opening) {
    const std::vector<float> hidden = hiddenAcross(renderer, opening);
    return std::accumulate(hidden.begin(), hidden.end(), 0.0f);
}

TEST_F(Cracks, AreAsWideAsTheyHaveOpened) {
    const float one = pixelsHidden(renderer(), 20.0f / 200) / 20;
    EXPECT_GT(one, 0.45f) << "it is dark inside";
    EXPECT_EQ(pixelsHidden(renderer(), 0), 0);
    for (const float pixels : {2.0f, 6.0f, 12.0f})
        EXPECT_NEAR(pixelsHidden(renderer(), pixels / 200) / one, pixels, 0.1f);
    for (const float pixels : {0.4f, 0.8f, 1.2f})  // fainter where thinner
        EXPECT_NEAR(pixelsHidden(renderer(), pixels / 200) / one, pixels, 0.3f * pixels);
}

TEST_F(Cracks, SeenFromTheSideTheWallBeyondIsLit) {
    const std::vector<float> straight = hiddenAcross(renderer(), 20.0f / 200);
    EXPECT_NEAR(straight[33], straight[46], 0.02f);
    const std::vector<float> aside = hiddenAcross(renderer(), 20.0f / 200, 0.8f);
    const auto middle = aside.begin() + 40;
    const float near_side = *std::max_element(aside.begin(), middle);
    EXPECT_GT(near_side, 0.8f * straight[40]);
    EXPECT_LT(*(middle + 5), 0.85f * near_side) << "farther right, where the wall is near";
    EXPECT_GT(*(middle + 5), 0.1f);
}

/// Pixels of the face that are clearly red, where all is white but the inside of the body.
size_t redPixels(Renderer& renderer, Scene& scene) {
    const float red[] = {0.8f, 0.02f, 0.02f};
    std::ranges::copy(red, scene.view.look.interior_colour);
    const Image picture = drawPicture(renderer, scene);
    size_t count = 0;
    for (int y = 20; y < 60; ++y)
        for (int x = 60; x < 140; ++x)
            count += decoded(picture.at(x, y)[0]) > 2 * decoded(picture.at(x, y)[1]) &&
                     decoded(picture.at(x, y)[0]) > 0.1f;
    return count;
}

TEST_F(Cracks, SeenFromTheSideTheWallIsOfTheBrokenMaterial) {
    Scene straight = crackedFace(20.0f / 200, 0), aside = crackedFace(20.0f / 200, 0.8f);
    EXPECT_LT(redPixels(renderer(), straight), 10u) << "it is dark inside";
    EXPECT_GT(redPixels(renderer(), aside), 40u * 3);
}

TEST_F(Cracks, AreOfTheMaterialOfTheirOwnBody) {
    Scene scene = crackedFace(20.0f / 200, 0.8f, 1);
    scene.view.more_looks = {scene.view.look};
    EXPECT_EQ(redPixels(renderer(), scene), 0u) << "look 0 alone is red inside";
    scene.view.more_looks = {scene.view.look};
    EXPECT_GT(redPixels(renderer(), scene), 40u * 3);
}

TEST_F(Cracks, TheEdgesOfACrackInRoughMaterialAreChipped) {
    Scene rough = crackedFace(20.0f / 200, 0);
    rough.view.look.noise_strength = 0.5f;
    rough.view.look.noise_scale = 0.05f;
    EXPECT_GT(redPixels(renderer(), rough), 40u);
}

/// Edges of one line are told from either end.
TEST_F(Cracks, AreRaggedAlikeWhicheverWayTheirEdgesAreTold) {
    const auto rough = [](bool turned) {
        Scene scene = crackedFace({.cells = 2, .crack_width = 20.0f / 200, .turned_lines = turned});
        scene.view.look.noise_strength = 0.5f;
        scene.view.look.noise_scale = 0.05f;
        return scene;
    };
    EXPECT_LT(differingPixels(drawPicture(renderer(), rough(false)), drawPicture(renderer(), rough(true)), 8),
              10u);
}

TEST_F(Cracks, BetweenFragmentsThatHaveMovedLieInTheMiddle) {
    Scene scene = crackedFace({.cells = 2, .crack_width = 1});
    const auto isLeft = [&](uint32_t cell) { return scene.body->cellCentre(cell).z > 0; };
    uint32_t lowest[2] = {8, 8};
    for (uint32_t cell = 8; cell-- > 0;) lowest[isLeft(cell)] = cell;
    for (const float moved : {-3.0f, 3.0f}) {  // px, one of both alone
        scene.body->write(
            *scene.mesh, [&](uint32_t cell) { return lowest[isLeft(cell)]; },
            [&](uint32_t slot) {
                return Motion{.translation = {0, 0, isLeft(slot) == (moved > 0) ? moved / 200 : 0}};
            },
            [&](uint32_t a, uint32_t b) { return isLeft(a) != isLeft(b); });
        scene.view.show_cracks = true;
        const Image with = drawPicture(renderer(), scene);
        scene.view.show_cracks = false;
        const Image without = drawPicture(renderer(), scene);
        double sum = 0, weighted = 0;
        for (int x = 60; x < 140; ++x) {
            const double hides = std::abs(with.at(x, 40)[1] - without.at(x, 40)[1]);
            sum += hides;
            weighted += hides * (x + 0.5);
        }
        ASSERT_GT(sum, 0);
        EXPECT_NEAR(weighted / sum, 100 - 0.5 * moved, 0.4);  // the left is at z > 0
    }
}

}  // namespace
}  // namespace demolish::engine::test
