// SPDX-License-Identifier: Apache-2.0
// Grit and dust of a brick that breaks: born where it breaks, the same in every run, and never felt by it.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "sim_cuda/api/errors.h"
#include "tests/physics/solver/breaking_scene.h"
#include "tests/physics/solver/lattice_body.h"
#include "tests/physics/solver/solver_under_test.h"

namespace demolish::tests {
namespace {

constexpr uint32_t kCells = 640;

SceneSetup dustyScene() {
    SceneSetup setup = breakingScene();
    setup.params.effects.on = true;
    setup.params.effects.finest = 0.05;
    setup.params.hand_over = setup.params.sleeping = true;
    return setup;
}

/// On the CPU: what is exported lies in the host's memory.
struct Shown {
    std::vector<GrainInstance> grains;
    std::vector<PuffInstance> puffs;
    std::vector<FragmentTransform> transforms;
    std::vector<uint32_t> fragment;

    explicit Shown(Solver& solver)
        : grains(solver.exportSizes().grains),
          puffs(solver.exportSizes().puffs),
          transforms(kCells),
          fragment(kCells) {
        EffectCommands commands{};
        RenderStreams streams;
        streams.transforms = {transforms.data(), transforms.size()};
        streams.particle_fragment = {fragment.data(), fragment.size()};
        streams.grains = {grains.data(), grains.size()};
        streams.puffs = {puffs.data(), puffs.size()};
        streams.effect_commands = {&commands, 1};
        solver.exportFrame(streams, true);
        grains.resize(commands.grains.instance_count);
        puffs.resize(commands.puffs.instance_count);
    }
    size_t seenPuffs() const {
        return static_cast<size_t>(
            std::count_if(puffs.begin(), puffs.end(), [](const auto& puff) { return puff.radius > 0; }));
    }
};

void run(Solver& solver, int frames) {
    for (int frame = 0; frame < frames; ++frame) ASSERT_EQ(solver.advanceFrame(), StepStatus::kOk);
}

class EffectsOnEither : public OnEitherDevice {};
class EffectsOnTheCpu : public OnTheCpu {};

TEST_F(EffectsOnEither, WhoWatchesDoesNotAct) {
    SceneSetup without = dustyScene();
    without.params.effects.on = false;
    auto plain = makeSolver(without), dusty = makeSolver(dustyScene());
    for (int frame = 0; frame < 30; ++frame) {
        ASSERT_EQ(plain->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(dusty->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(plain->stateHash(), dusty->stateHash()) << "frame " << frame;
    }
    EXPECT_EQ(plain->effectsHash(), 0u);
    EXPECT_NE(dusty->effectsHash(), 0u);
    EXPECT_FALSE(plain->stats().effects_shown);
    EXPECT_TRUE(dusty->stats().effects_shown);
}

TEST_F(EffectsOnEither, TheSameBitsInEveryRunAndOnTheCpu) {
    auto cpu = makeCpuSolver(dustyScene()), other = makeSolver(dustyScene());
    for (int frame = 0; frame < 40; ++frame) {
        ASSERT_EQ(cpu->advanceFrame(frame % 3 == 0 ? 0.4 : 1), StepStatus::kOk);
        ASSERT_EQ(other->advanceFrame(frame % 3 == 0 ? 0.4 : 1), StepStatus::kOk);
        ASSERT_EQ(cpu->effectsHash(), other->effectsHash()) << "frame " << frame;
    }
    EXPECT_NE(cpu->effectsHash(), 0u);
}

TEST_F(EffectsOnEither, ASnapshotHoldsThem) {
    auto solver = makeSolver(dustyScene());
    const Snapshot start = solver->save();
    run(*solver, 12);
    const Snapshot middle = solver->save();
    const uint64_t then = solver->effectsHash();
    run(*solver, 8);
    const uint64_t later = solver->effectsHash();
    EXPECT_NE(then, later);
    solver->restore(middle);
    EXPECT_EQ(solver->effectsHash(), then);
    run(*solver, 8);
    EXPECT_EQ(solver->effectsHash(), later);
    solver->restore(start);
    EXPECT_EQ(solver->effectsHash(), 0u);
    EXPECT_FALSE(solver->stats().effects_shown);
    run(*solver, 12);
    EXPECT_EQ(solver->effectsHash(), then);
}

TEST_F(EffectsOnEither, SwitchedOffTheyAreGoneAndWhatIsOpenThrowsNothingOffLater) {
    auto solver = makeSolver(dustyScene());
    run(*solver, 12);
    EffectsSettings settings = dustyScene().params.effects;
    settings.on = false;
    solver->setEffects(settings);
    EXPECT_EQ(solver->effectsHash(), 0u);
    settings.on = true;
    solver->setEffects(settings);
    EXPECT_FALSE(solver->stats().effects_shown);
    SceneSetup without = dustyScene();
    without.params.effects.on = false;
    auto plain = makeSolver(without);
    run(*plain, 12);
    plain->setEffects(settings);
    run(*plain, 10);
    run(*solver, 10);
    EXPECT_EQ(plain->effectsHash(), solver->effectsHash());
}

TEST_F(EffectsOnTheCpu, AnyNumberOfThreadsGivesTheSameBits) {
    std::vector<uint64_t> hashes;
    for (const size_t threads : {1, 2, 5}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        auto solver = makeCpuSolver(dustyScene());
        run(*solver, 20);
        hashes.push_back(solver->effectsHash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

TEST_F(EffectsOnTheCpu, BornWhereTheBodyBreaksAndAsMuchAsItsMaterialSays) {
    SceneSetup setup = dustyScene();
    setup.params.effects.crumbling = false;
    auto solver = makeCpuSolver(setup);
    while (solver->stats().bonds_broken == 0) run(*solver, 1);
    EXPECT_FALSE(Shown(*solver).grains.empty() && solver->stats().fragments > 1);
    run(*solver, 3);
    const Shown shown(*solver);
    ASSERT_GT(shown.grains.size(), 1000u);
    // A face throws its grains from a disc as large as itself about its middle, which lies above the floor.
    float disc = 0;
    for (const BondGeometry& bond : setup.bodies[0].body->bonds)
        disc = std::max(disc, static_cast<float>(std::sqrt(bond.area / std::numbers::pi)));
    for (const GrainInstance& grain : shown.grains) {
        EXPECT_LT(std::abs(grain.position.x) + std::abs(grain.position.z), 1.5f);
        EXPECT_GT(grain.position.y, -disc);  // those of the soles are lifted in the next frame
        EXPECT_GE(grain.size, 0.03f * 0.05f * 0.999f);
        EXPECT_LE(grain.size, 0.03f * 0.4f * 1.001f);
    }
    // Faces between cells of different fragments, each h^2 large.
    const BreakableBody& body = *setup.bodies[0].body;
    double faces = 0;
    for (const BondGeometry& bond : body.bonds)
        faces += shown.fragment[bond.i] != shown.fragment[bond.j] ? bond.area : 0;
    const double expected =
        faces * setup.bodies[0].material.debris.grit_per_m2 * std::pow(0.05 * 0.03 / 1e-3, -kSizeExponent);
    EXPECT_NEAR(static_cast<double>(shown.grains.size()) / expected, 1, 0.1);
}

TEST_F(EffectsOnTheCpu, SizesOfCellsCrumbsAndGrainsFollowOneLaw) {
    SceneSetup setup = dustyScene();
    setup.params.effects.finest = kFinestGrain;
    auto solver = makeCpuSolver(setup);
    run(*solver, 60);
    const Shown shown(*solver);
    std::vector<uint32_t> cells(kCells);
    for (const uint32_t slot : shown.fragment) ++cells[slot];
    constexpr double kSpacing = 0.03;
    std::vector<double> sizes;  // h
    for (uint32_t slot = 0; slot < kCells; ++slot) {
        if (cells[slot] == 0) continue;
        const double scale = 1 - double{kShrinkStep} * shown.transforms[slot].shrink;
        EXPECT_GE(scale, cells[slot] == 1 ? 0.34 : 1);
        sizes.push_back(scale * std::cbrt(cells[slot]));
    }
    const size_t pieces = sizes.size();
    for (const GrainInstance& grain : shown.grains) sizes.push_back(grain.size / kSpacing);
    EXPECT_GT(pieces, 100u);
    const auto larger = [&](double s) {
        return static_cast<double>(
            std::count_if(sizes.begin(), sizes.end(), [s](double x) { return x > s; }));
    };
    // A line through log N over log s, as looks.md 4 has it.
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (double at = 0.05; at < 5; at *= 1.25) {
        if (larger(at) < 1) break;
        const double u = std::log(at), v = std::log(larger(at));
        n += 1, x += u, y += v, xx += u * u, xy += u * v;
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    EXPECT_LT(slope, -1.8);
    EXPECT_GT(slope, -2.8);
}

TEST_F(EffectsOnTheCpu, TheOldestMakeRoom) {
    SceneSetup setup = dustyScene();
    setup.params.effects.grains = 500;
    setup.params.effects.puffs = 40;
    auto few = makeCpuSolver(setup), many = makeCpuSolver(dustyScene());
    run(*few, 25);
    run(*many, 25);
    const Shown held(*few), all(*many);
    EXPECT_EQ(held.grains.size(), 500u);
    EXPECT_EQ(held.puffs.size(), 40u);
    ASSERT_GT(all.grains.size(), 500u);
    // The last 500 births, with the same bits, each at its number modulo the room.
    for (size_t number = all.grains.size() - 500; number < all.grains.size(); ++number)
        EXPECT_EQ(held.grains[number % 500].seed, all.grains[number].seed) << number;
}

TEST_F(EffectsOnTheCpu, InTheEndAllGrainsLieAndTheDustIsGone) {
    auto solver = makeCpuSolver(dustyScene());
    run(*solver, 20);
    EXPECT_GT(Shown(*solver).seenPuffs(), 50u);
    EXPECT_TRUE(solver->stats().effects_moving);
    int frames = 0;
    for (; solver->stats().effects_moving && frames < 2000; ++frames) run(*solver, 1);
    EXPECT_LT(frames, 2000);
    const Shown rest(*solver);
    EXPECT_EQ(rest.seenPuffs(), 0u);
    const uint64_t hash = solver->effectsHash();
    run(*solver, 5);
    EXPECT_EQ(solver->effectsHash(), hash);
    for (const GrainInstance& grain : rest.grains) EXPECT_LT(grain.position.y, 0.3f * grain.size + 1e-4f);
    EXPECT_TRUE(solver->stats().effects_shown);
}

TEST_F(EffectsOnTheCpu, AWholeBodyHasNoneAndABadAmountIsRefused) {
    SceneSetup setup = freeBody(latticeBody(3, 3, 3, 0.1));
    setup.params.effects.on = true;
    auto solver = makeCpuSolver(setup);
    run(*solver, 3);
    EXPECT_FALSE(solver->stats().effects_shown);
    setup.params.effects.grit = 11;
    EXPECT_THROW(makeCpuSolver(setup), UsageError);
    setup.params.effects.grit = std::nan("");
    EXPECT_THROW(makeCpuSolver(setup), UsageError);
    setup.params.effects.grit = 1;
    setup.params.effects.grains = 0;
    EXPECT_THROW(makeCpuSolver(setup), UsageError);
}

}  // namespace
}  // namespace demolish::tests
