// SPDX-License-Identifier: Apache-2.0
#include "tests/bullet/bullet_pictures.h"

#include <vector>

#include "app/session/picture.h"
#include "engine/render/fracture_mesh.h"

namespace demolish::bullet {
namespace {

constexpr uint32_t kLongAgo = 1000;  // frames since the bodies came apart: cracks are as wide as they get

/// From the body at rest to where Bullet has the piece.
FragmentTransform transformOf(const World& world, size_t number, const Piece& piece,
                              const BodyInstance& body) {
    const glm::dquat turn = world.turn(number),
                     rest(body.rotation.w, body.rotation.x, body.rotation.y, body.rotation.z);
    const glm::dvec3 place(body.position.x, body.position.y, body.position.z);
    const glm::dvec3 moved = world.centre(number) + turn * (place - piece.centre);
    const glm::quat q(turn * rest);
    FragmentTransform transform;
    transform.rotation = {q.x, q.y, q.z, q.w};
    transform.translation = {float(moved.x), float(moved.y), float(moved.z)};
    transform.age = kLongAgo;
    return transform;
}

FrameFilesOptions filesIn(const std::filesystem::path& folder, int width, int height, uint64_t frames) {
    FrameFilesOptions options;
    options.folder = folder;
    options.frames = frames;
    options.width = width;
    options.height = height;
    return options;
}

}  // namespace

void placePieces(Session& session, const World& world, std::span<const Piece> pieces) {
    engine::FractureMesh& mesh = *session.mesh();
    std::vector<FragmentTransform> transforms(mesh.particleCount());
    for (size_t i = 0; i < pieces.size(); ++i)
        transforms[pieces[i].fragment] =
            transformOf(world, i, pieces[i], session.built().setup.bodies[pieces[i].body]);
    mesh.stream(engine::StreamId::kTransforms).upload(std::as_bytes(std::span(transforms)));
}

std::vector<engine::SphereDraw> ballsOf(const World& world) {
    std::vector<engine::SphereDraw> spheres;
    for (const World::Ball& ball : world.balls())
        spheres.push_back(
            {{float(ball.centre.x), float(ball.centre.y), float(ball.centre.z)}, float(ball.radius)});
    return spheres;
}

Pictures::Pictures(Session& session, HeadlessStage& stage, const std::filesystem::path& folder, int width,
                   int height, uint64_t frames)
    : session_(session),
      stage_(stage),
      files_(filesIn(folder, width, height, frames)),
      view_(makeFrameView(session.shot(), session.built().cells.of_body, width, height,
                          engine::RenderQuality::kFull)),
      target_(width, height,
              [this](uint64_t frame, engine::Image image) { files_.add(frame, std::move(image)); }) {}

void Pictures::draw(const World& world, std::span<const Piece> pieces) {
    placePieces(session_, world, pieces);
    stage_.renderer().draw(session_.mesh(), ballsOf(world), view_, target_.framebuffer());
    target_.submit(drawn_++);
}

void Pictures::finish() {
    target_.finish();
    files_.finish();
}

}  // namespace demolish::bullet
