// SPDX-License-Identifier: Apache-2.0
// Each scene shows one thing that can go wrong.
#include "tests/render/scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>

#include "engine/render/film.h"
#include "engine/render/frame_capture.h"
#include "engine/scene/lens.h"
#include "engine/surroundings/surroundings.h"
#include "tests/render/gl_fixture.h"

namespace demolish::engine::test {
namespace {

constexpr int kWidth = 480, kHeight = 270;

FrameView standardView() {
    FrameView view;
    view.camera.eye = {1.75f, 1.2f, 2.35f};
    view.camera.target = {0.0f, 0.42f, 0.0f};
    view.width = kWidth;
    view.height = kHeight;
    view.scene_radius = 1.8f;
    view.look.noise_scale = 0.03f;
    view.look.crack_width = 0.004f;
    return view;
}

float random(uint32_t h) {
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return static_cast<float>((h ^ (h >> 16)) & 0xffffu) / 65535.0f;
}

/// Pieces fly apart from where they were hit: near ones far and turning, the others hardly.
Motion scatter(const BlockBody& body, uint32_t slot, glm::vec3 hit) {
    const glm::vec3 centre = body.cellCentre(slot), away = centre - hit;
    const float near = std::exp(-4.0f * glm::dot(away, away));
    const glm::vec3 axis =
        glm::normalize(glm::vec3(random(slot * 3 + 1), random(slot * 3 + 2), random(slot * 3 + 3)) - 0.48f);
    Motion motion;
    motion.rotation = glm::angleAxis(1.6f * near * (0.3f + random(slot)), axis);
    const glm::vec3 jump =
        near * (0.55f + 0.5f * random(slot + 77)) * glm::normalize(away + glm::vec3(0, 0.25f, 0));
    motion.translation = centre + jump - motion.rotation * centre;
    return motion;
}

Scene blockScene(const BlockOptions& options) {
    Scene scene;
    scene.body = std::make_unique<BlockBody>(options);
    scene.mesh = std::make_unique<FractureMesh>(scene.body->makeMesh());
    scene.view = standardView();
    return scene;
}

bool noCracks(uint32_t, uint32_t) {
    return false;
}

constexpr glm::vec3 kHit{0.55f, 0.75f, 0.35f};

/// Cells far from the hit stay one fragment, those near fly alone or in pairs.
uint32_t brokenSlot(const BlockBody& body, uint32_t cell) {
    if (glm::distance(body.cellCentre(cell), kHit) > 0.62f) return 0;
    return cell - (cell % 8 == 1 ? 1 : 0);
}

Scene ball(ViewMode mode, ColourMap colours) {
    Scene scene = blockScene({.cells = 8, .jitter = 0.6f, .roundness = 1.0f, .subdivisions = 4});
    const BlockBody& body = *scene.body;
    body.write(
        *scene.mesh, [&](uint32_t cell) { return brokenSlot(body, cell); },
        [&](uint32_t slot) { return slot == 0 ? Motion{} : scatter(body, slot, kHit); },
        [](uint32_t a, uint32_t b) { return (a * 7 + b * 3) % 5 == 0; });
    scene.spheres = {{{0.86f, 0.86f, 0.78f}, 0.13f}};
    scene.view.mode = mode;
    scene.view.colour_map = colours;
    return scene;
}

Scene crackedBlock() {
    Scene scene = wholeBlock();
    scene.body->write(
        *scene.mesh, [](uint32_t) { return 0u; }, [](uint32_t) { return Motion{}; },
        [](uint32_t a, uint32_t b) { return (a + b) % 3 != 0; });
    return scene;
}

Scene draft() {
    Scene scene = brokenBlock();
    scene.view.quality = RenderQuality::kDraft;
    scene.view.samples = 1;
    return scene;
}

/// Grit all round where it was hit, and a cloud of dust.
Scene dustyBlock(RenderQuality quality) {
    Scene scene = brokenBlock();
    std::vector<GrainDraw> grains;
    for (uint32_t k = 0; k < 3000; ++k) {
        const glm::vec3 away = glm::vec3(random(5 * k), random(5 * k + 1), random(5 * k + 2)) - 0.5f;
        const float size = 0.004f * std::pow(0.002f + 0.998f * random(5 * k + 3), -0.45f);
        grains.push_back({kHit + 1.1f * away, size, {random(k) < 0.5f ? 0x5a82u : 0u, 0x5a820000u}, 97 * k});
        grains.back().position.y = std::max(grains.back().position.y, 0.3f * size);
    }
    std::vector<PuffDraw> puffs;
    for (uint32_t k = 0; k < 40; ++k) {
        const glm::vec3 away = glm::vec3(random(7 * k), random(7 * k + 1), random(7 * k + 2)) - 0.5f;
        puffs.push_back({kHit + glm::vec3(0.9f, 0.5f, 0.9f) * away, 0.1f + 0.1f * random(k), 0.25f, 0.3f,
                         0x9e3779b9u * k});
    }
    writeEffects(*scene.mesh, grains, puffs);
    scene.view.quality = quality;
    return scene;
}

Scene marbleBlock() {
    Scene scene = brokenBlock();
    SurfaceLook& look = scene.view.look;
    std::fill_n(look.exterior_colour, 3, 0.7f);
    std::fill_n(look.interior_colour, 3, 0.75f);
    std::fill_n(look.texture_colour, 3, 0.12f);
    look.texture = SolidTexture::kVeins;
    look.texture_size = 0.1f;
    return scene;
}

Scene glassBlock() {
    Scene scene = brokenBlock();
    scene.view.quality = RenderQuality::kDraft;
    scene.view.look.refraction_index = 1.5f;
    scene.view.look.absorption[0] = 2;
    scene.view.look.absorption[1] = 0.5f;
    scene.view.look.absorption[2] = 0.8f;
    return scene;
}

Scene emptyFloor() {
    Scene scene;
    scene.view = standardView();
    return scene;
}

const std::map<std::string, std::function<Scene()>>& table() {
    static const std::map<std::string, std::function<Scene()>> scenes{
        {"whole_block", wholeBlock},
        {"cracked_block", crackedBlock},
        {"broken_block", brokenBlock},
        {"broken_block_draft", draft},
        {"broken_ball", [] { return ball(ViewMode::kSurface, ColourMap::kFragment); }},
        {"ball_particles_fragment", [] { return ball(ViewMode::kParticles, ColourMap::kFragment); }},
        {"ball_particles_value", [] { return ball(ViewMode::kParticles, ColourMap::kDamage); }},
        {"dusty_block", [] { return dustyBlock(RenderQuality::kFull); }},
        {"dusty_block_draft", [] { return dustyBlock(RenderQuality::kDraft); }},
        {"marble_block", marbleBlock},
        {"glass_block", glassBlock},
        {"empty_floor", emptyFloor},
    };
    return scenes;
}

}  // namespace

void writeEffects(FractureMesh& mesh, const std::vector<GrainDraw>& grains,
                  const std::vector<PuffDraw>& puffs) {
    static_assert(sizeof(GrainDraw) == 32 && sizeof(PuffDraw) == 32);
    const auto g = static_cast<uint32_t>(grains.size()), p = static_cast<uint32_t>(puffs.size());
    const uint32_t commands[8] = {36, g, 0, 0, 4, p, 0, 0};
    mesh.stream(StreamId::kGrains).upload(std::as_bytes(std::span(grains)));
    mesh.stream(StreamId::kPuffs).upload(std::as_bytes(std::span(puffs)));
    mesh.stream(StreamId::kEffectCommands).upload(std::as_bytes(std::span(commands)));
    mesh.showEffects(true, true);
}

Scene wholeBlock() {
    Scene scene = blockScene({.cells = 4, .jitter = 0.5f});
    scene.body->write(
        *scene.mesh, [](uint32_t) { return 0u; }, [](uint32_t) { return Motion{}; }, noCracks);
    return scene;
}

Scene greyBall(float albedo, float roughness) {
    Scene scene = ball(ViewMode::kSurface, ColourMap::kFragment);
    scene.spheres.clear();
    scene.body->write(
        *scene.mesh, [](uint32_t) { return 0u; }, [](uint32_t) { return Motion{}; }, noCracks);
    scene.view.show_cracks = false;
    for (float& channel : scene.view.look.exterior_colour) channel = albedo;
    scene.view.look.exterior_roughness = roughness;
    scene.view.look.noise_strength = 0;
    return scene;
}

Scene brokenBlock() {
    Scene scene = blockScene({.cells = 2, .size = 0.8f, .jitter = 0.4f, .subdivisions = 2});
    const BlockBody& body = *scene.body;
    body.write(
        *scene.mesh, [](uint32_t cell) { return cell; },
        [&](uint32_t slot) {
            Motion motion;
            const glm::vec3 centre = body.cellCentre(slot);
            motion.rotation = glm::angleAxis(0.25f + 0.1f * static_cast<float>(slot),
                                             glm::normalize(glm::vec3(1, 2, 0.5f)));
            motion.translation = centre * 1.45f + glm::vec3(0, 0.08f, 0) - motion.rotation * centre;
            return motion;
        },
        noCracks);
    return scene;
}

void giveHalvesTwoLooks(Scene& scene, float spread) {
    const BlockBody& body = *scene.body;
    std::vector<uint32_t> looks;
    for (uint32_t cell = 0; cell < body.cellCount(); ++cell)
        looks.push_back(body.cellCentre(cell).x > 0 ? 1 : 0);
    scene.mesh = std::make_unique<FractureMesh>(body.makeMesh(looks));
    body.write(
        *scene.mesh, [&](uint32_t cell) { return spread > 0 ? cell : 0u; },
        [&](uint32_t cell) { return Motion{.translation = spread * body.cellCentre(cell)}; },
        [](uint32_t, uint32_t) { return false; });
}

Scene solidBlock() {
    Scene scene = emptyFloor();
    ColliderDraw block;
    block.position = {0, 0.5f, 0};
    scene.view.colliders = {block};
    return scene;
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const auto& [name, make] : table()) names.push_back(name);
    return names;
}

Scene makeScene(const std::string& name) {
    const auto found = table().find(name);
    if (found == table().end()) throw std::invalid_argument("No test scene is called " + name);
    return found->second();
}

size_t differingPixels(const Image& a, const Image& b, int more_than) {
    size_t count = 0;
    for (size_t i = 0; i < a.pixels.size(); i += 4) {
        int difference = 0;
        for (size_t c = 0; c < 3; ++c)
            difference = std::max(difference, std::abs(a.pixels[i + c] - b.pixels[i + c]));
        count += difference > more_than;
    }
    return count;
}

bool isBody(uint32_t id) {
    return id < kColliderId;
}

float decoded(uint8_t value) {
    const float v = static_cast<float>(value) / 255;
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

void putIntoFurnace(FrameView& view, glm::vec3 radiance) {
    view.lighting.surroundings = makeSurroundings(RadiancePicture(32, 16, radiance), std::nullopt);
    view.lighting.sun_colour = glm::vec3(0);
    view.lighting.floor = FloorMaterial::kNone;
    view.lighting.tone = ToneCurve::kNone;
    view.lighting.exposure = 1;
}

Image drawPicture(Renderer& renderer, const Scene& scene) {
    Image picture;
    FrameCapture capture(scene.view.width, scene.view.height,
                         [&](uint64_t, Image image) { picture = std::move(image); });
    if (scene.view.transparent) {
        Film film(shaderFolder());
        film.begin(scene.view.width, scene.view.height);
        renderer.draw(scene.mesh.get(), scene.spheres, pictureView(scene.view, {}, 0, 1), film.framebuffer());
        film.add();
        film.develop(scene.view.lighting, capture.framebuffer());
    } else {
        renderer.draw(scene.mesh.get(), scene.spheres, scene.view, capture.framebuffer());
    }
    capture.submit(0);
    capture.finish();
    return picture;
}

}  // namespace demolish::engine::test
