// SPDX-License-Identifier: Apache-2.0
// Experiment files, plans and their portions.
#include "app/breakage/experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "app/breakage/jobs.h"
#include "app/breakage/plan.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {
namespace {

std::string complaint(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Experiment, TheShippedOnesAreReadAndTheDefaultStandsFirst) {
    const auto names = experimentNames();
    ASSERT_GE(names.size(), 4u);
    EXPECT_EQ(names[0], "breakage");
    std::set<std::string> titles, texts;
    for (const auto& name : names) {
        BreakageExperiment experiment = findExperiment(name);
        EXPECT_FALSE(experiment.why.empty()) << name;
        titles.insert(experiment.title);
        experiment.name = experiment.title = experiment.why = "";
        texts.insert(experimentJson(experiment));
    }
    EXPECT_EQ(titles.size(), names.size());
    EXPECT_EQ(texts.size(), names.size()) << "two readings are the same";
}

TEST(Experiment, TakesFromAnotherWhatItDoesNotSay) {
    const TemporaryFolder folder;
    folder.write("base.toml", "[material]\nfriction = 0.4\n[impact]\nfastest_mps = 60\n");
    const auto file = folder.write("mine.toml",
                                   "like = \"base\"\ntitle = \"mine\"\n[material]\nfriction = 0.1\n"
                                   "[specimen]\nlarge_grains = \"scaled\"\n[broken]\nrule = \"crack\"\n");
    const BreakageExperiment experiment = loadExperiment(file);
    EXPECT_EQ(experiment.name, "mine");
    EXPECT_EQ(experiment.friction, 0.1);
    EXPECT_EQ(experiment.fastest, 60);
    EXPECT_TRUE(experiment.scaled_grains);
    EXPECT_EQ(experiment.rule, BreakRule::kMeridional);
}

TEST(Experiment, ComplaintsNameFileAndLine) {
    const TemporaryFolder folder;
    const auto wrong = [&](const std::string& text) {
        const auto file = folder.write("bad.toml", text);
        return complaint([&] { loadExperiment(file); });
    };
    EXPECT_THAT(wrong("[material]\nfriction = 9\n"), testing::HasSubstr("bad.toml:2"));
    EXPECT_THAT(wrong("[material]\nfrictoin = 0.1\n"), testing::HasSubstr("frictoin"));
    EXPECT_THAT(wrong("\"material.friction\" = 0.1\n"), testing::HasSubstr("material.friction"));
    EXPECT_THAT(wrong("[broken]\nrule = \"maybe\"\n"), testing::HasSubstr("crack"));
    EXPECT_THAT(wrong("[specimen]\nsmall_m = 4e-5\n"), testing::HasSubstr("small_m below large_m"));
    EXPECT_THAT(wrong("[impact]\nslowest_mps = 90\n"), testing::HasSubstr("slowest_mps below"));
    EXPECT_THAT(wrong("like = \"bad\"\n"), testing::HasSubstr("too many files"));
    EXPECT_THAT(complaint([] { findExperiment("teapot"); }), testing::HasSubstr("breakage"));
}

TEST(Experiment, ItsRecordGivesItBack) {
    BreakageExperiment experiment = findExperiment("breakage");
    experiment.fracture_energy = 1.0 / 3;
    experiment.scaled_grains = true;
    experiment.rule = BreakRule::kMeridional;
    const std::string record = experimentJson(experiment);
    const BreakageExperiment again = experimentFromJson(record);
    EXPECT_EQ(experimentJson(again), record);
    EXPECT_EQ(again.fracture_energy, 1.0 / 3);
    EXPECT_THROW(experimentFromJson("{\"name\": 1}"), InputFileError);
}

TEST(Experiment, SameGrainsAndScaledGrains) {
    BreakageExperiment experiment;
    EXPECT_EQ(specimenOf(experiment, 0, 3).grains, 1000u);
    EXPECT_EQ(specimenOf(experiment, 1, 3).grains, 3375u);
    EXPECT_NE(specimenOf(experiment, 0, 3).seed, specimenOf(experiment, 0, 4).seed);
    EXPECT_NE(specimenOf(experiment, 0, 3).seed, specimenOf(experiment, 1, 3).seed);
    experiment.scaled_grains = true;
    EXPECT_EQ(specimenOf(experiment, 1, 3).grains, 1000u);
    EXPECT_EQ(velocitiesOf(experiment).front(), experiment.slowest);
    EXPECT_EQ(velocitiesOf(experiment).back(), experiment.fastest);
    EXPECT_EQ(velocitiesOf(experiment).size(), experiment.velocities);
}

/// Spheres of scaled grains are alike; with strength by (13), sigma_c^2 = Gamma E / (pi a_b (1 - nu^2)), so
/// are their strengths once Gamma grows as the size does.
TEST(Experiment, GammaOfTheLargeSpecimenIsItsOwn) {
    BreakageExperiment experiment;
    experiment.large_energy_factor = 1.5;
    EXPECT_EQ(materialOf(experiment, 0).fracture_energy, experiment.fracture_energy);
    EXPECT_EQ(materialOf(experiment, 1).fracture_energy, 1.5 * experiment.fracture_energy);
}

TEST(Plan, ItemsHoldEveryRunOnce) {
    BreakagePlan plan;
    plan.experiments.resize(2);
    plan.experiments[1].packings = 7;
    EXPECT_EQ(plan.items().size(), 2u) << "a whole reading is one simulation";
    plan.batch = 64;
    std::set<std::tuple<uint32_t, uint32_t, uint32_t, uint32_t>> seen;
    for (const auto& item : plan.items()) {
        EXPECT_LE(item.size(), 64u);
        for (const BreakageRun& run : item) {
            EXPECT_EQ(run.experiment, item[0].experiment);
            EXPECT_TRUE(seen.insert({run.experiment, run.size, run.speed, run.packing}).second);
        }
    }
    EXPECT_EQ(seen.size(), 2u * 10 * 30 + 2u * 10 * 7);
}

TEST(Plan, AFolderKeepsToItsPlan) {
    const TemporaryFolder folder;
    BreakagePlan plan;
    plan.experiments.resize(1);
    settlePlan(plan, folder.path());
    settlePlan(plan, folder.path());
    EXPECT_EQ(readPlan(folder.path()).json(), plan.json());
    EXPECT_EQ(readPlan(folder.path()).fingerprint(), plan.fingerprint());
    BreakagePlan other = plan;
    other.experiments[0].friction += 1e-12;
    EXPECT_NE(other.fingerprint(), plan.fingerprint());
    EXPECT_THROW(settlePlan(other, folder.path()), UsageError);
    folder.write("plan.json", "{}");
    EXPECT_THROW(readPlan(folder.path()), InputFileError);
}

TEST(Jobs, EachHasADeviceOfItsOwn) {
    EXPECT_EQ(visibleDevice(2, nullptr), "2");
    EXPECT_EQ(visibleDevice(1, "4,GPU-17"), "GPU-17");
    EXPECT_THROW(visibleDevice(2, "4,5"), UsageError);
    EXPECT_NO_THROW(checkGpus(2, 2));
    EXPECT_THROW(checkGpus(3, 2), UsageError);
}

}  // namespace
}  // namespace demolish::test
