// SPDX-License-Identifier: Apache-2.0
// Scenes whose bodies have models, materials and motion of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "app/bridge/host_frame.h"
#include "app/session/built_shot.h"
#include "app/session/scene_file.h"
#include "app/session/shot_bodies.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

const std::string kTwo =
    "version = 1\n"
    "material_preset = \"stone\"\n"
    "height_m = 2\n"
    "body = [\n"
    "  { model = \"models/block.obj\", particles = 90 },\n"
    "  { model = \"models/rabbit_paper.obj\", material = \"glass\", height_m = 0.5, particles = 60, "
    "position_m = [3, 0.2, 0], rotation_deg = [0, 0, 90], velocity_mps = [-2, 0, 0], spin_radps = [0, 4, "
    "0] },\n"
    "  { model = \"models/block.obj\", position_m = [-4, 0, 0] },\n"
    "]\n"
    "[particles]\nfull = 180\ndraft = 90\n";

Shot sceneOf(const std::string& text) {
    const TemporaryFolder folder;
    Shot shot = loadSceneFile(folder.write("scene.toml", text));
    shot.device = DeviceChoice::kCpu;
    return shot;
}

std::string complaintAbout(const std::string& text) {
    try {
        sceneOf(text);
    } catch (const InputFileError& error) {
        return error.what();
    }
    return "";
}

/// Particles of a body that are not in one piece with its first.
uint32_t particlesApart(const BuiltShot& built, size_t number) {
    size_t first = 0;
    for (size_t b = 0; b < number; ++b) first += built.setup.bodies[b].body->particles.size();
    const auto fragment = readFrame(*built.solver, FrameParts::kFragments).particle_fragment;
    uint32_t apart = 0;
    for (size_t i = 0; i < built.setup.bodies[number].body->particles.size(); ++i)
        apart += fragment[first + i] != fragment[first];
    return apart;
}

TEST(SceneBodies, ReadWhatTheyHaveOfTheirOwn) {
    const Shot shot = sceneOf(kTwo);
    ASSERT_EQ(shot.bodies.size(), 3u);
    EXPECT_EQ(shot.model.filename(), "block.obj") << "of the body that the ball hits";
    EXPECT_EQ(shot.material_name, "stone");
    EXPECT_FALSE(shot.bodies[0].model);
    EXPECT_DOUBLE_EQ(shot.bodies[0].particles_share, 0.5);
    const SceneBody& rabbit = shot.bodies[1];
    EXPECT_EQ(rabbit.model.value().filename(), "rabbit_paper.obj");
    EXPECT_EQ(rabbit.material.value().name, "glass");
    EXPECT_GT(rabbit.material.value().look.refraction_index, 1);
    EXPECT_DOUBLE_EQ(rabbit.height_share, 0.25);
    EXPECT_DOUBLE_EQ(rabbit.position.x, 1.5) << "in heights of the shot";
    EXPECT_NEAR(rabbit.turn.z, std::sqrt(0.5), 1e-12);
    EXPECT_EQ(rabbit.velocity, (Double3{-2, 0, 0}));
    EXPECT_EQ(rabbit.spin, (Double3{0, 4, 0}));
    EXPECT_EQ(firstAlike(shot.bodies), (std::vector<size_t>{0, 1, 2}));
    EXPECT_EQ(looksOf(shot).of_body, (std::vector<uint32_t>{0, 1, 0}));
}

TEST(SceneBodies, TheShotIsAboutTheBodyThatTheFastestBallHits) {
    const Shot shot = sceneOf(kTwo +
                              "[[ball]]\nat_s = 1\nvelocity_mps = 3\n[[ball]]\nat_s = 2\nbody = "
                              "1\nvelocity_mps = 9\n");
    EXPECT_EQ(subjectOf(shot), 1u);
    EXPECT_EQ(shot.model.filename(), "rabbit_paper.obj");
    EXPECT_EQ(shot.material_name, "glass");
    EXPECT_EQ(shot.bodies[0].model.value().filename(), "block.obj");
    EXPECT_EQ(shot.bodies[0].material.value().name, "stone");
    EXPECT_FALSE(shot.bodies[1].model || shot.bodies[1].material);
    EXPECT_DOUBLE_EQ(placementOf(shot).height, 0.5);
}

TEST(SceneBodies, AreNodesOfAModelAndLieAsItsAxesSay) {
    const Shot shot = sceneOf(
        "version = 1\nmodel = \"models/block.obj\"\nup = \"z\"\nbody = [\n  {},\n  { node = \"lid\" },\n"
        "  { model = \"models/wolf.obj\", up = \"y\" },\n  { model = \"models/wolf.obj\" },\n]\n");
    EXPECT_EQ(partOf(shot, shot.bodies[0]), (ModelPart{"", UpAxis::kZ}));
    EXPECT_EQ(partOf(shot, shot.bodies[1]), (ModelPart{"lid", UpAxis::kZ}));
    EXPECT_EQ(partOf(shot, shot.bodies[2]), (ModelPart{"", UpAxis::kY}));
    EXPECT_EQ(partOf(shot, shot.bodies[3]), (ModelPart{"", UpAxis::kZ}));
    EXPECT_EQ(firstAlike(shot.bodies), (std::vector<size_t>{0, 1, 2, 3}));
    EXPECT_EQ(placementOf(shot, shot.bodies[1]).part.node, "lid");
    Shot other = shot;
    other.bodies[1].part->node = "door";
    EXPECT_EQ(changeBetween(shot, other), Change::kBody);
}

TEST(SceneBodies, KeepTheSizeOfTheirFilesWhereAUnitIsSaid) {
    const std::string bodies =
        "body = [\n  {},\n  { model = \"models/block.obj\", unit = \"ft\", position_m = [3, 0, 0] },\n]\n";
    const Shot shot = sceneOf("version = 1\nmodel = \"models/wolf.obj\"\nheight_m = 0.5\n" + bodies +
                              "[particles]\ndraft = 30\n");
    EXPECT_FALSE(placementOf(shot, shot.bodies[0]).keep_units);
    const BuiltShot built = prepareShot(shot, {.draw_geometry = false}, {});
    const auto drawn = loadSolidMesh(shot.bodies[1].model.value(), {.keep_units = true});
    EXPECT_NEAR(built.setup.bodies[0].body->bounds_max.y, 0.5, 1e-9);
    EXPECT_NEAR(built.setup.bodies[1].body->bounds_max.y, 0.3048 * meshInfo(*drawn).bounds_max.y, 1e-9);
    EXPECT_NEAR(built.setup.bodies[1].position.x, 3, 1e-12);

    const Shot alone = sceneOf("version = 1\nmodel = \"models/block.obj\"\nunit = \"cm\"\n");
    EXPECT_TRUE(alone.keeps_size);
    EXPECT_EQ(placementOf(alone).part.unit, 0.01);
    Shot other = alone;
    other.part.unit = 0.001;
    EXPECT_EQ(changeBetween(alone, other), Change::kBody);
}

TEST(SceneBodies, MistakesAreNamedWithFileLineAndKey) {
    EXPECT_THAT(complaintAbout("version = 1\nbody = [\n  { model = \"models/block.obj\" },\n  {},\n]\n"),
                HasSubstr("scene.toml:4: body[1].model is missing"));
    EXPECT_THAT(complaintAbout("version = 1\n[[body]]\nmodel = \"no.obj\"\n"),
                AllOf(HasSubstr("scene.toml:3: body[0].model"), HasSubstr("no such file")));
    const std::string block = "version = 1\n[[body]]\nmodel = \"models/block.obj\"\n";
    EXPECT_THAT(complaintAbout(block + "material = \"wood\"\n"),
                AllOf(HasSubstr("scene.toml:4: body[0].material"), HasSubstr("ceramic")));
    EXPECT_THAT(complaintAbout(block + "particles = 1\n"), HasSubstr("scene.toml:4: body[0].particles"));
    EXPECT_THAT(complaintAbout(block + "particles = 9\nparticle_size_m = 0.1\n"),
                HasSubstr("exclude each other"));
    EXPECT_THAT(complaintAbout(block + "up = \"x\"\n"), HasSubstr("scene.toml:4: body[0].up must be"));
    EXPECT_THAT(complaintAbout(block + "unit = \"mile\"\n"), HasSubstr("scene.toml:4: body[0].unit must be"));
    EXPECT_THAT(complaintAbout(block + "unit = \"cm\"\nheight_m = 2\n"),
                HasSubstr("scene.toml:5: body[0].height_m and unit exclude each other"));
    EXPECT_THAT(complaintAbout(block + "speed_mps = 9\n"), HasSubstr("no setting 'body[0].speed_mps'"));
    EXPECT_THAT(complaintAbout(block + "velocity_mps = [1, 0, 0]\n[solver]\nsettle_s = 0.1\n"),
                HasSubstr("scene.toml:4: body[0].velocity_mps needs solver.settle_s = 0"));
    EXPECT_THAT(complaintAbout("version = 1\n"), HasSubstr("model is missing"));
}

TEST(SceneBodies, EachIsMadeOfItsOwnMeshAndTheirSumsAddUp) {
    const BuiltShot built = prepareShot(sceneOf(kTwo), {.draw_geometry = false}, {});
    ASSERT_EQ(built.setup.bodies.size(), 3u);
    EXPECT_EQ(built.cells.meshes.size(), 2u) << "read once each";
    const auto& first = *built.setup.bodies[0].body;
    const auto& rabbit = *built.setup.bodies[1].body;
    EXPECT_EQ(first.particles.size(), 45u) << "half of the draft's";
    EXPECT_EQ(rabbit.particles.size(), 30u);
    EXPECT_EQ(built.setup.bodies[2].body->particles.size(), 90u);
    EXPECT_NEAR(rabbit.bounds_max.y - rabbit.bounds_min.y, 0.5, 1e-9);
    EXPECT_NEAR(first.bounds_max.y - first.bounds_min.y, 2, 1e-9);
    double mass = 0;
    for (const BodyInstance& body : built.setup.bodies) {
        EXPECT_NEAR(body.body->cells_volume / body.body->mesh_volume, 1, 1e-9);
        mass += body.material.density * body.body->mesh_volume;
    }
    EXPECT_EQ(built.setup.bodies[1].material.name, "glass");
    EXPECT_EQ(built.setup.bodies[1].velocity, (Double3{-2, 0, 0}));
    EXPECT_NE(built.setup.bodies[0].threshold_share, built.setup.bodies[1].threshold_share);
    const auto solver = makeCpuSolver(built.setup);
    solver->measure();
    EXPECT_NEAR(solver->stats().mass / mass, 1, 1e-9);
}

TEST(SceneBodies, ParticlesAreScaledInProportion) {
    Shot shot = sceneOf(kTwo);
    shot.fineness.particles = 360;
    const BuiltShot more = prepareShot(shot, {.draw_geometry = false}, {});
    EXPECT_EQ(more.setup.bodies[0].body->particles.size(), 180u);
    EXPECT_EQ(more.setup.bodies[2].body->particles.size(), 360u);
    shot.bodies.assign(900, shot.bodies[2]);
    shot.fineness.particles = 20'000;
    try {
        prepareShot(shot, {.draw_geometry = false}, {});
        FAIL() << "no complaint";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("900 bodies of 20000 particles are 18000000"));
    }
}

TEST(SceneBodies, GiveTheSameBitsForAnyNumberOfThreads) {
    const Shot shot = sceneOf(kTwo);
    uint64_t hash[2] = {};
    for (const size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const BuiltShot built = buildShot(shot, {.draw_geometry = false}, {});
        for (int frame = 0; frame < 30; ++frame) ASSERT_EQ(built.solver->advanceFrame(), StepStatus::kOk);
        hash[threads - 1] = built.solver->stateHash();
        EXPECT_GT(built.solver->stats().bonds_broken, 0u) << "the rabbit falls";
    }
    EXPECT_EQ(hash[0], hash[1]);
}

/// Thrown onto a block of plaster at several times the velocity that breaks either.
TEST(SceneBodies, WhatDoesNotBreakStaysWholeAndBreaksWhatItHits) {
    const std::string bodies =
        "version = 1\nmodel = \"models/block.obj\"\nheight_m = 0.3\nmaterial_preset = \"plaster\"\n"
        "body = [\n  {},\n  { height_m = 0.2, position_m = [0, 0.35, 0], velocity_mps = [0, -30, 0]";
    const std::string end = " },\n]\n[particles]\nfull = 80\ndraft = 80\n[impact]\nkind = \"none\"\n";
    uint32_t pieces[2] = {};
    for (const bool breaks : {false, true}) {
        const Shot shot = sceneOf(bodies + (breaks ? "" : ", breaks = false") + end);
        EXPECT_EQ(shot.bodies[1].breaks, breaks);
        const BuiltShot built = buildShot(shot, {.draw_geometry = false}, {});
        for (int frame = 0; frame < 20; ++frame) ASSERT_EQ(built.solver->advanceFrame(), StepStatus::kOk);
        EXPECT_GT(built.solver->stats().bonds_broken, 20u);
        pieces[breaks ? 1 : 0] = particlesApart(built, 1);
    }
    EXPECT_EQ(pieces[0], 0u);
    EXPECT_GT(pieces[1], 0u) << "it would have broken";
    EXPECT_THAT(complaintAbout(bodies + ", breaks = 0" + end),
                HasSubstr("body[1].breaks must be true or false"));
}

}  // namespace
}  // namespace demolish
