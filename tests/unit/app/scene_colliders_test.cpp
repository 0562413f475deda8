// SPDX-License-Identifier: Apache-2.0
// Colliders in scene files: what is read, what is refused with file and line, and where each is drawn.
#include "app/session/scene_colliders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "app/session/data_folder.h"
#include "app/session/scene_file.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/scene_texts.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

using test::complaintAbout;
using test::kHead;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(SceneColliders, ReadsColliders) {
    const TemporaryFolder folder;
    const Shot shot = loadSceneFile(
        folder.write("step.toml", kHead + "height_m = 0.5\n"
                                          "[[collider]]\nshape = \"box\"\nsize_m = [1, 0.2, 0.6]\n"
                                          "position_m = [0.1, 0.1, -0.3]\nrotation_deg = [0, 90, 0]\n"
                                          "[[collider]]\nshape = \"plane\"\nnormal = [0, 0, 2]\n"
                                          "position_m = [7, 8, -1.5]\n"));
    const std::vector<Collider> colliders = collidersOf(shot);
    ASSERT_EQ(colliders.size(), 3u);
    EXPECT_EQ(std::get<Plane>(colliders[0].shape), Plane{}) << "the floor comes first";
    const Box& box = std::get<Box>(colliders[1].shape);
    EXPECT_NEAR(box.size.y, 0.2, 1e-12);
    EXPECT_NEAR(box.position.z, -0.3, 1e-12);
    EXPECT_NEAR(box.rotation.y, std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(box.rotation.w, std::sqrt(0.5), 1e-12);
    const Plane& wall = std::get<Plane>(colliders[2].shape);
    EXPECT_EQ(wall.normal, (Double3{0, 0, 1}));
    EXPECT_NEAR(wall.offset, -1.5, 1e-12);
    const auto drawn = drawnColliders(shot, {{0.2, 0.3, 0.5}, 1});
    ASSERT_EQ(drawn.size(), 2u) << "the floor is not among them";
    EXPECT_NEAR(drawn[0].half_size.x, 0.5f, 1e-6f);
    EXPECT_EQ(drawn[1].shape, engine::ColliderShape::kPlane);
    const glm::vec3 half = drawn[1].half_size;
    const glm::vec3 middle = drawn[1].position + drawn[1].rotation * glm::vec3(0, 0, half.z);
    EXPECT_NEAR(glm::distance(middle, glm::vec3(0.2f, 0.3f, -1.5f)), 0, 1e-6f)
        << "where the scene is nearest";
    EXPECT_GT(std::min(half.x, half.y), 3.0f);
}

/// Any normal, the floor's and its opposite among them: the drawn face lies on the plane and looks along it.
TEST(SceneColliders, PlanesAreDrawnWhereTheyAre) {
    for (const Double3 n : {Double3{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, {0.48, 0.6, -0.64}}) {
        Shot shot;
        shot.height = 2;
        shot.colliders = {Plane{n, -0.25}};
        const auto drawn = drawnColliders(shot, {{1, 2, 3}, 1.5});
        ASSERT_EQ(drawn.size(), 1u);
        const glm::vec3 normal(n.x, n.y, n.z), half = drawn[0].half_size;
        EXPECT_NEAR(glm::distance(drawn[0].rotation * glm::vec3(0, 0, 1), normal), 0, 1e-5f);
        for (const float x : {-1.0f, 1.0f}) {
            const glm::vec3 corner = drawn[0].position + drawn[0].rotation * (glm::vec3(x, -x, 1) * half);
            EXPECT_NEAR(glm::dot(normal, corner), -0.5f, 1e-5f);
        }
    }
}

TEST(SceneColliders, TurnsOfAColliderFollowEachOther) {
    const TemporaryFolder folder;
    const Shot shot = loadSceneFile(folder.write(
        "turned.toml",
        kHead + "collider = [{ shape = \"box\", size_m = [1, 2, 3], rotation_deg = [90, 0, 90] }]\n"));
    const Quaternion q = std::get<Box>(shot.colliders.at(0).shape).rotation;
    // y turns to z about x, and z stays about z; x stays about x and turns to y about z.
    const glm::dquat turn(q.w, q.x, q.y, q.z);
    EXPECT_NEAR(glm::length(turn * glm::dvec3(0, 1, 0) - glm::dvec3(0, 0, 1)), 0, 1e-12);
    EXPECT_NEAR(glm::length(turn * glm::dvec3(1, 0, 0) - glm::dvec3(0, 1, 0)), 0, 1e-12);
}

/// Of a mesh half of whose surface is red and half dark red, the mean of both.
TEST(SceneColliders, HaveAColourOfTheirOwnThatOfTheirFileOrTheFloors) {
    const TemporaryFolder folder;
    folder.write("two.mtl", "newmtl bright\nKd 0.8 0 0\nnewmtl dark\nKd 0.4 0 0\n");
    folder.write("two.obj",
                 "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nusemtl bright\n"
                 "f 1 3 2\nf 1 2 4\nf 1 4 3\nusemtl dark\nf 2 3 5\nf 2 5 4\nf 3 4 5\n");
    const std::string mesh = "[[collider]]\nshape = \"mesh\"\nmodel = \"two.obj\"\ncells = 8\n";
    const Shot shot = loadSceneFile(folder.write(
        "set.toml", kHead + mesh + mesh + "colour = [0.1, 0.2, 0.3]\n[[collider]]\nshape = \"sphere\"\n" +
                        "radius_m = 0.1\nposition_m = [0, 3, 0]\n"));
    const auto drawn = drawnColliders(shot, {{0, 0, 0}, 1});
    ASSERT_EQ(drawn.size(), 3u);
    const double bright = 1.5, dark = 1.5 * std::sqrt(3.0);  // areas, m^2
    ASSERT_TRUE(drawn[0].colour && drawn[1].colour);
    EXPECT_NEAR(drawn[0].colour->x, (0.8 * bright + 0.4 * dark) / (bright + dark), 1e-5);
    EXPECT_EQ(drawn[0].colour->y, 0.0f);
    EXPECT_EQ(*drawn[1].colour, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_FALSE(drawn[2].colour);
}

TEST(SceneColliders, CollidersGrowWithTheBody) {
    const TemporaryFolder folder;
    Shot shot = loadSceneFile(folder.write(
        "a.toml", kHead + "collider = [{ shape = \"box\", size_m = [1, 2, 3], position_m = [0, 4, 0] }]\n"));
    EXPECT_EQ(changeBetween(shot, shot), Change::kNothing);
    Shot other = shot;
    std::get<Box>(other.colliders[0].shape).size.x = 2;
    EXPECT_EQ(changeBetween(shot, other), Change::kSolver);
    shot.height *= 2;
    const Box box = std::get<Box>(collidersOf(shot).at(1).shape);
    EXPECT_NEAR(box.size.z, 6, 1e-12);
    EXPECT_NEAR(box.position.y, 8, 1e-12);
}

TEST(SceneColliders, ReadsRoundColliders) {
    const TemporaryFolder folder;
    Shot shot = loadSceneFile(
        folder.write("round.toml", kHead + "height_m = 0.5\n"
                                           "[[collider]]\nshape = \"sphere\"\nradius_m = 0.3\n"
                                           "position_m = [0.1, 0.2, -0.3]\nfriction = 0\n"
                                           "[[collider]]\nshape = \"capsule\"\nradius_m = 0.1\n"
                                           "from_m = [0, 1, 0]\nto_m = [0, 1, 2]\nrestitution = 0.8\n"));
    shot.height *= 2;
    const std::vector<Collider> colliders = collidersOf(shot);
    ASSERT_EQ(colliders.size(), 3u);
    const Sphere& ball = std::get<Sphere>(colliders[1].shape);
    EXPECT_NEAR(ball.radius, 0.6, 1e-12);
    EXPECT_NEAR(ball.position.z, -0.6, 1e-12);
    EXPECT_EQ(colliders[1].friction, 0.0);
    EXPECT_EQ(colliders[1].restitution, std::nullopt);
    const Capsule& rod = std::get<Capsule>(colliders[2].shape);
    EXPECT_NEAR(rod.radius, 0.2, 1e-12);
    EXPECT_NEAR(rod.from.y, 2, 1e-12);
    EXPECT_NEAR(rod.to.z, 4, 1e-12);
    EXPECT_EQ(colliders[2].restitution, 0.8);
    const auto drawn = drawnColliders(shot, {{0, 1, 0}, 1});
    ASSERT_EQ(drawn.size(), 2u);
    EXPECT_EQ(drawn[0].shape, engine::ColliderShape::kSphere);
    EXPECT_NEAR(drawn[0].half_size.y, 0.6f, 1e-6f);
    EXPECT_EQ(drawn[1].shape, engine::ColliderShape::kCapsule);
    EXPECT_NEAR(glm::distance(drawn[1].position, glm::vec3(0, 2, 2)), 0, 1e-5f);
    EXPECT_NEAR(drawn[1].half_size.z, 2.2f, 1e-5f);
    EXPECT_NEAR(std::abs((drawn[1].rotation * glm::vec3(0, 0, 1)).z), 1, 1e-5f);
}

TEST(SceneColliders, ReadsACollidersMesh) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(dataFolder() / "assets/models/block.obj", folder.path() / "rock.obj");
    const std::string mesh = "[[collider]]\nshape = \"mesh\"\nmodel = \"rock.obj\"\ncells = 16\n";
    Shot shot = loadSceneFile(folder.write(
        "mesh.toml",
        kHead + "height_m = 0.5\n" + mesh +
            "scale = 0.25\nposition_m = [0, 0.1, 2]\nrotation_deg = [0, 90, 0]\nfriction = 1\n"));
    shot.height *= 2;
    const Collider collider = collidersOf(shot).at(1);
    const MeshShape& shape = std::get<MeshShape>(collider.shape);
    EXPECT_NEAR(shape.scale, 0.5, 1e-12);
    EXPECT_NEAR(shape.position.z, 4, 1e-12);
    EXPECT_NEAR(shape.rotation.y, std::sqrt(0.5), 1e-12);
    EXPECT_EQ(collider.friction, 1.0);
    EXPECT_EQ(changeBetween(shot, shot), Change::kNothing);
    const auto drawn = drawnColliders(shot, {{0, 1, 0}, 1});
    ASSERT_EQ(drawn.size(), 1u);
    ASSERT_NE(drawn[0].triangles, nullptr);
    EXPECT_EQ(drawn[0].triangles->size() % 18, 0u) << "of three corners, six numbers each";
    EXPECT_NEAR(drawn[0].half_size.x, 0.5f, 1e-6f);

    const auto complaint = [&](const std::string& keys) {
        try {
            loadSceneFile(folder.write("bad.toml", kHead + keys));
        } catch (const InputFileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(complaint(mesh), "");
    EXPECT_THAT(complaint("[[collider]]\nshape = \"mesh\"\n"), HasSubstr("collider[0].model is missing"));
    EXPECT_THAT(
        complaint("[[collider]]\nshape = \"mesh\"\nmodel = \"none.obj\"\n"),
        testing::AllOf(HasSubstr("bad.toml:5"), HasSubstr("collider[0].model"), HasSubstr("none.obj")));
    EXPECT_THAT(complaint(mesh + "scale = 0\n"), HasSubstr("scale must be"));
    EXPECT_THAT(complaint("[[collider]]\nshape = \"mesh\"\nmodel = \"rock.obj\"\ncells = 4\n"),
                HasSubstr("cells must be"));
    EXPECT_THAT(complaint("[[collider]]\nshape = \"mesh\"\nmodel = \"rock.obj\"\ncells = 800\n"),
                testing::AllOf(HasSubstr("collider[0].model"), HasSubstr("are possible; choose")));
}

TEST(SceneColliders, BadCollidersAreRefusedWithASentence) {
    const auto complaint = [](const std::string& keys) {
        return complaintAbout(kHead + "[[collider]]\n" + keys + "\n");
    };
    EXPECT_EQ(complaint("shape = \"box\"\nsize_m = [1, 1, 1]"), "");
    EXPECT_THAT(complaint("size_m = [1, 1, 1]"), HasSubstr("collider[0].shape is missing"));
    EXPECT_THAT(complaint("shape = \"blob\""), HasSubstr("must be one of box, capsule, mesh, plane, sphere"));
    EXPECT_THAT(complaint("shape = \"box\""), HasSubstr("collider[0].size_m is missing"));
    for (const char* size :
         {"[1, 0, 1]", "[1, -1, 1]", "[1e5, 1, 1]", "[nan, 1, 1]", "[inf, 1, 1]", "[1, 1]"})
        EXPECT_THAT(complaint(std::string("shape = \"box\"\nsize_m = ") + size),
                    testing::AllOf(HasSubstr("scene.toml:5"), HasSubstr("collider[0].size_m must be")))
            << size;
    EXPECT_THAT(complaint("shape = \"box\"\nsize_m = [1, 1, 1]\nposition_m = [nan, 0, 0]"),
                HasSubstr("position_m must be"));
    EXPECT_THAT(complaint("shape = \"box\"\nsize_m = [1, 1, 1]\nrotation_deg = 3"),
                HasSubstr("rotation_deg must be"));
    EXPECT_THAT(complaint("shape = \"box\"\nsize_m = [1, 1, 1]\nnormal = [0, 1, 0]"),
                HasSubstr("there is no setting 'collider[0].normal'"));
    EXPECT_THAT(complaint("shape = \"plane\"\nnormal = [0, 0, 0]"), HasSubstr("must not be zero"));
    EXPECT_THAT(complaint("shape = \"sphere\""), HasSubstr("collider[0].radius_m is missing"));
    EXPECT_THAT(complaint("shape = \"sphere\"\nradius_m = 0"), HasSubstr("radius_m must be"));
    EXPECT_THAT(complaint("shape = \"sphere\"\nradius_m = 1\nsize_m = [1, 1, 1]"),
                HasSubstr("there is no setting 'collider[0].size_m'"));
    EXPECT_THAT(complaint("shape = \"capsule\"\nradius_m = 1\nfrom_m = [0, 0, 0]"),
                HasSubstr("collider[0].to_m is missing"));
    EXPECT_THAT(complaint("shape = \"capsule\"\nradius_m = 1\nfrom_m = [0, 1, 0]\nto_m = [0, 1, 0]"),
                HasSubstr("to_m must be at least 0.001 m from from_m"));
    for (const char* own : {"friction = -0.1", "friction = 1.6", "restitution = 0", "restitution = 1.1"})
        EXPECT_THAT(complaint(std::string("shape = \"plane\"\n") + own), HasSubstr(" must be ")) << own;
    std::string many = kHead;
    for (uint32_t i = 0; i < kMaxColliders; ++i) many += "[[collider]]\nshape = \"plane\"\n";
    EXPECT_THAT(complaintAbout(many), HasSubstr("has 8 entries; at most 7 are possible"));
}

}  // namespace
}  // namespace demolish
