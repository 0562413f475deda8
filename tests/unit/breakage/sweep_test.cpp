// SPDX-License-Identifier: Apache-2.0
// The experiment itself, small: specimens hold below and break above, items do not depend on who computes
// them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/breakage/batch_run.h"
#include "app/breakage/figures.h"
#include "app/breakage/report.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"
#include "sim_cuda/physics/scalar.h"
#include "sim_cuda/solver/double_solver.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

/// The default material on few grains.
BreakagePlan smallPlan(std::vector<double> ends, uint32_t velocities, uint32_t packings) {
    BreakagePlan plan;
    BreakageExperiment experiment = findExperiment("breakage");
    experiment.grains = 60;
    experiment.packings = packings;
    experiment.slowest = ends[0];
    experiment.fastest = ends[1];
    experiment.velocities = velocities;
    plan.experiments = {experiment};
    return plan;
}

TEST(Sweep, SpecimensHoldBelowAndBreakAbove) {
    const BreakagePlan plan = smallPlan({8, 120}, 2, 2);
    const auto runs = plan.items()[0];
    const ItemResult result = runItem(plan, runs, false);
    ASSERT_EQ(result.outcomes.size(), 8u);
    for (size_t k = 0; k < runs.size(); ++k) {
        EXPECT_EQ(result.outcomes[k].split, runs[k].velocity > 50) << runs[k].velocity << " m/s";
        if (runs[k].velocity < 50) {
            EXPECT_EQ(result.outcomes[k].children, 1u);
        }
    }
    const EnergyLedger& energy = result.energy;
    const double sum = energy.kinetic + energy.elastic + energy.damping + energy.friction + energy.fracture;
    EXPECT_NEAR(sum / result.impact_energy, 1, 0.02);
}

TEST(Sweep, MicrometresFitIntoSinglePrecision) {
    // No similarity transform: the same impact in double precision, bond for bond until chaos sets in.
    const BreakagePlan plan = smallPlan({45, 45}, 1, 1);
    SceneSetup setup = sceneOf(plan, plan.items()[0]);
    const auto single = makeCpuSolver(setup), exact = makeCpuSolverDouble(setup);
    ASSERT_EQ(single->stats().time_step, exact->stats().time_step);
    for (int frame = 0; frame < 3; ++frame) {
        ASSERT_EQ(single->advanceFrame(), StepStatus::kOk);
        ASSERT_EQ(exact->advanceFrame(), StepStatus::kOk);
    }
    single->measure();
    exact->measure();
    const FrameStats &a = single->stats(), &b = exact->stats();
    EXPECT_GT(b.energy.elastic, 0.1 * b.energy.kinetic) << "not yet in touch";
    EXPECT_NEAR(a.energy.kinetic / b.energy.kinetic, 1, 1e-4);
    EXPECT_NEAR(a.energy.elastic / b.energy.elastic, 1, 1e-4);
    EXPECT_NEAR(a.max_stress_ratio / b.max_stress_ratio, 1, 1e-3);
}

TEST(Sweep, AModelAMillionTimesAsLargeBreaksBitForBitAlike) {
    // E, rho and velocities kept, lengths, times and Gamma times L: nothing else changes, and for a power of
    // two no bit of any mantissa either, unless something leaves the range of single precision.
    const BreakagePlan small = smallPlan({45, 45}, 1, 1);
    BreakagePlan large = small;
    constexpr double kScale = 1048576;
    for (double& diameter : large.experiments[0].diameters) diameter *= kScale;
    large.experiments[0].fracture_energy *= kScale;
    large.experiments[0].duration *= kScale;
    const ItemResult a = runItem(small, small.items()[0], false), b = runItem(large, large.items()[0], false);
    EXPECT_EQ(a.substeps, b.substeps);
    EXPECT_EQ(b.impact_energy, a.impact_energy * kScale * kScale * kScale);
    EXPECT_GT(a.bonds_broken, 0u);
    EXPECT_EQ(b.bonds_broken, a.bonds_broken);
    for (size_t k = 0; k < a.outcomes.size(); ++k) {
        EXPECT_EQ(b.outcomes[k].largest, a.outcomes[k].largest);
        EXPECT_EQ(b.outcomes[k].children, a.outcomes[k].children);
    }
}

TEST(Sweep, SpecimensStandOutOfEachOthersReachAndJustAboveTheWall) {
    const BreakagePlan plan = smallPlan({30, 40}, 3, 4);
    const auto runs = plan.items()[0];
    const SceneSetup setup = sceneOf(plan, runs);
    ASSERT_EQ(setup.bodies.size(), runs.size());
    for (size_t i = 0; i < runs.size(); ++i) {
        const BodyInstance& a = setup.bodies[i];
        EXPECT_EQ(a.velocity.y, -runs[i].velocity);
        double lowest = 1;
        for (const Particle& grain : a.body->particles)
            lowest = std::min(lowest, a.position.y + grain.seed.y - grain.contact_radius);
        EXPECT_NEAR(lowest, 1e-3 * plan.experiments[0].diameters[runs[i].size], 1e-12);
        for (size_t j = 0; j < i; ++j) {
            const BodyInstance& b = setup.bodies[j];
            EXPECT_GE(std::hypot(a.position.x - b.position.x, a.position.z - b.position.z),
                      4 * 36e-6 * 0.999);
            const bool same = runs[i].size == runs[j].size && runs[i].packing == runs[j].packing;
            EXPECT_EQ(a.body == b.body, same) << "a packing is made once";
        }
    }
}

TEST(Sweep, AnItemIsTheSameBytesHoweverOftenItIsComputed) {
    const TemporaryFolder folder;
    const BreakagePlan plan = smallPlan({30, 60}, 1, 2);
    settlePlan(plan, folder.path());
    const auto runs = plan.items()[0];
    const ItemResult once = runItem(plan, runs, false), again = runItem(plan, runs, false);
    EXPECT_EQ(itemJson(plan, 0, runs, once), itemJson(plan, 0, runs, again));
    writeItem(folder.path(), plan, 0, runs, once);
    const auto read = readItem(folder.path(), plan, 0, runs);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(itemJson(plan, 0, runs, *read), itemJson(plan, 0, runs, once));
    EXPECT_FALSE(readItem(folder.path(), plan, 1, runs).has_value());
}

TEST(Sweep, ForeignAndTornItemsAreRefused) {
    const TemporaryFolder folder;
    BreakagePlan plan = smallPlan({30, 60}, 1, 1);
    settlePlan(plan, folder.path());
    const auto runs = plan.items()[0];
    ItemResult result;
    result.outcomes.resize(runs.size());
    writeItem(folder.path(), plan, 0, runs, result);
    BreakagePlan other = plan;
    other.experiments[0].friction = 0.11;
    EXPECT_THROW(readItem(folder.path(), other, 0, runs), InputFileError);
    const std::string text = readTextFile(itemFile(folder.path(), 0));
    writeTextFile(itemFile(folder.path(), 0), text.substr(0, text.size() / 2));
    EXPECT_THROW(readItem(folder.path(), plan, 0, runs), InputFileError);
    EXPECT_THROW(gatherResults(plan, folder.path()), InputFileError);
}

TEST(Sweep, GatheringWritesTablesAndFigures) {
    const TemporaryFolder folder;
    const BreakagePlan plan = smallPlan({20, 60}, 5, 3);
    settlePlan(plan, folder.path());
    const auto runs = plan.items()[0];
    ItemResult result;
    for (const BreakageRun& run : runs) {
        Outcome outcome;
        outcome.split = outcome.meridional = run.velocity >= 40;
        outcome.children = outcome.split ? 2 + run.packing : 1;
        result.outcomes.push_back(outcome);
    }
    result.impact_energy = result.energy.kinetic = 1;
    writeItem(folder.path(), plan, 0, runs, result);
    gatherResults(plan, folder.path());
    const auto lines = [&](const char* name) {
        const std::string text = readText(folder.path() / name);
        return std::count(text.begin(), text.end(), '\n');
    };
    EXPECT_EQ(lines("specimens.csv"), 1 + 2 * 5 * 3);
    EXPECT_EQ(lines("probability.csv"), 1 + 2 * 5);
    const auto json = nlohmann::json::parse(readText(folder.path() / "breakage.json"));
    const auto& cell = json["readings"][0]["sizes"][0]["sweep"][2];
    EXPECT_EQ(cell["velocity_mps"], 40);
    EXPECT_EQ(cell["broken"], 3);
    EXPECT_NEAR(cell["wilson_95"][0].get<double>(), 0.438, 1e-3);
    EXPECT_EQ(cell["children"][4], 1);
    EXPECT_EQ(json["readings"][0]["sizes"][0]["velocity_of_half"], 35);
    for (const char* name : {"figure_1.svg", "figure_2a.svg", "figure_2b.svg"}) {
        const std::string svg = readText(folder.path() / name);
        EXPECT_NE(svg.find("impact velocity, m/s"), std::string::npos) << name;
        EXPECT_NE(svg.find("stated in the paper"), std::string::npos) << name;
        EXPECT_EQ(svg.find("nan"), std::string::npos) << name;
        EXPECT_EQ(svg.rfind("</svg>\n"), svg.size() - 7) << name;
    }
}

TEST(Sweep, FiguresReachThePointsThatThePaperStates) {
    const BreakagePlan plan = smallPlan({50, 60}, 3, 1);  // a tick each m/s
    const auto statistics = summarise(plan, {});
    const auto hasTick = [](const std::string& svg, const char* tick) {
        return svg.find(std::string(">") + tick + "</text>") != std::string::npos;
    };
    EXPECT_TRUE(hasTick(probabilityFigure(plan, statistics), "60"));
    EXPECT_TRUE(hasTick(probabilityFigure(plan, statistics), "35"));
    EXPECT_TRUE(hasTick(childrenFigure(plan, statistics, 1), "43"));
    EXPECT_FALSE(hasTick(childrenFigure(plan, statistics, 1), "42"));
}

}  // namespace
}  // namespace demolish::test
