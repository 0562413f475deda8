// SPDX-License-Identifier: Apache-2.0
// The test pictures: named scenes that goldens, facts and the eye all use.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "engine/image/image.h"
#include "engine/render/renderer.h"
#include "tests/render/block_body.h"

namespace demolish::engine::test {

struct Scene {
    std::unique_ptr<BlockBody> body;
    std::unique_ptr<FractureMesh> mesh;
    std::vector<SphereDraw> spheres;
    FrameView view;
};

/// 480 x 270 and smaller scenes; the context must be current.
Scene makeScene(const std::string& name);
/// Names that makeScene knows.
std::vector<std::string> sceneNames();

/// Draws one frame into a picture.
Image drawPicture(Renderer& renderer, const Scene& scene);

/// Linear, of sRGB.
float decoded(uint8_t value);
/// Nothing but even light from everywhere, shown as it is.
void putIntoFurnace(FrameView& view, glm::vec3 radiance);

/// Pixels of which a channel differs by more than `more_than` of 255.
size_t differingPixels(const Image& a, const Image& b, int more_than);
/// Is this id of Renderer::fragmentIds() a piece of the body?
bool isBody(uint32_t id);

/// A grain and a puff as the streams hold them (FractureMesh).
struct GrainDraw {
    glm::vec3 position;
    float size;
    uint32_t rotation[2] = {0, 0x7fff0000u};
    uint32_t seed;
    float heat = 0;
};
struct PuffDraw {
    glm::vec3 position;
    float radius, depth, age;
    uint32_t seed;
    float heat = 0;
};
/// Into a block's mesh, in place of what was there.
void writeEffects(FractureMesh& mesh, const std::vector<GrainDraw>& grains,
                  const std::vector<PuffDraw>& puffs);

/// A block in one piece, and the same broken into flying pieces.
Scene wholeBlock();
/// A whole ball of one grey, without shading noise and cracks.
Scene greyBall(float albedo, float roughness);
Scene brokenBlock();
/// Look 1 for the cells at x > 0, look 0 for the others; in one piece, or where `spread` is above 0 each cell
/// a piece that is by so much farther out.
void giveHalvesTwoLooks(Scene& scene, float spread);
/// In the place of the whole block a collider of its size.
Scene solidBlock();

}  // namespace demolish::engine::test
