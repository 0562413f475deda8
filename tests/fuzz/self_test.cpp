// SPDX-License-Identifier: Apache-2.0
// The fuzzers see what they are there to see: how a child ends, what two runs must have in common.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "tests/fuzz/files/mutation.h"
#include "tests/fuzz/shots/findings.h"
#include "tests/fuzz/support/child_program.h"

namespace demolish::fuzz {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

ChildEnd shell(const std::string& script, const ChildLimits& limits = {}) {
    return runChild({"sh", "-c", script}, limits, {"WORD=said"});
}

TEST(ChildProgram, SaysHowItEndedAndWhatItSaid) {
    const ChildEnd end = shell("echo $WORD; echo wrong >&2; exit 3");
    EXPECT_TRUE(end.endedWith(3));
    EXPECT_EQ(end.out, "said\n");
    EXPECT_EQ(end.err, "wrong\n");
    const ChildEnd crash = shell("kill -SEGV $$");
    EXPECT_EQ(crash.signal, SIGSEGV);
    EXPECT_FALSE(crash.endedWith(0));
    EXPECT_TRUE(runChild({"/no/such/program"}, {}).endedWith(127));
}

TEST(ChildProgram, WhatHangsIsEndedWithAllThatItStarted) {
    const ChildEnd end = shell("sleep 1000 & echo $!; wait", {.seconds = 0.3});
    EXPECT_TRUE(end.timed_out);
    EXPECT_FALSE(end.endedWith(0));
    EXPECT_EQ(describe(end).find("still running"), 0u);
    const std::string sleeper = end.out.substr(0, end.out.find('\n'));
    const ChildEnd left = shell("sleep 0.2; grep -q '^State:.[RSD]' /proc/" + sleeper + "/status");
    EXPECT_FALSE(left.endedWith(0)) << "the sleeper still runs";
}

TEST(ChildProgram, ProcessorTimeIsItsOwn) {
    const ChildEnd busy = shell("while :; do :; done", {.seconds = 600, .cpu_seconds = 0.2});
    EXPECT_TRUE(busy.timed_out);
    EXPECT_TRUE(shell("sleep 0.5", {.seconds = 600, .cpu_seconds = 0.4}).endedWith(0));
}

TEST(ChildProgram, IsKilledAtItsMoment) {
    const ChildEnd end = shell("sleep 1000", {.seconds = 60, .kill_after = 0.1});
    EXPECT_EQ(end.signal, SIGKILL);
    EXPECT_FALSE(end.timed_out);
}

TEST(CommandLine, QuotesWhatAShellWouldTakeApart) {
    EXPECT_EQ(commandLine({"a", "b c", "", "d"}), "a 'b c' '' d");
}

TEST(Mutation, IsTheSameForTheSameDiceAndLeavesLittleAsItWas) {
    const std::string seed = "version = 1\nheight_m = 0.5\n[impact]\nvelocity_mps = 10\n";
    size_t changed = 0;
    for (uint64_t index = 0; index < 200; ++index) {
        Dice once(1, index), again(1, index);
        const std::string bytes = mutated(seed, once);
        EXPECT_EQ(bytes, mutated(seed, again));
        changed += bytes != seed ? 1 : 0;
    }
    EXPECT_GT(changed, 180u);
}

/// A run in which all went well.
ShotRun goodRun() {
    ShotRun run;
    run.hashes = {1, 2, 3};
    run.frames = 30;
    run.brought_in = 100;
    return run;
}

auto kindIs(const std::string& kind) {
    return Field(&Finding::kind, kind);
}

TEST(Findings, GoodRunsHaveNone) {
    EXPECT_THAT(findingsOf(goodRun(), goodRun()), IsEmpty());
}

TEST(Findings, HashesThatDifferAndBooksThatDoNotCloseFail) {
    ShotRun watched = goodRun();
    watched.hashes[1] = 7;
    watched.closure = 1.03;
    const auto findings = findingsOf(goodRun(), watched);
    ASSERT_THAT(findings, ElementsAre(kindIs("hash"), kindIs("books")));
    watched = goodRun();
    watched.closure = 0.5;
    watched.weight_energy = 1e6;
    EXPECT_THAT(findingsOf(goodRun(), watched), IsEmpty()) << "next to nothing came in";
}

TEST(Findings, FaultsRefusalsAndSentencesWithoutAKnobFail) {
    ShotRun watched = goodRun();
    watched.faults = {"the mass is 1, not 2", "frame 3: not finite: particle 4"};
    watched.stopped = "Something is wrong.";
    watched.refused = "no";
    const auto findings = findingsOf(goodRun(), watched);
    EXPECT_THAT(findings, ElementsAre(kindIs("refusal"), kindIs("body"), kindIs("frame"), kindIs("status")));
    watched = goodRun();
    watched.stopped = "It became unstable; lower the impact velocity.";
    EXPECT_THAT(findingsOf(goodRun(), watched), IsEmpty());
}

}  // namespace
}  // namespace demolish::fuzz
