// SPDX-License-Identifier: Apache-2.0
// Children of the shell: their ends, their streams, and what they must not get or do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>

#include "app/process/child_process.h"

namespace demolish {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

ChildPlan shell(const std::string& script) {
    return {.words = {"sh", "-c", script}, .output = ChildStream::kPiped, .errors = ChildStream::kNothing};
}

std::string readAll(ChildProcess& child) {
    std::string text;
    std::array<uint8_t, 512> part{};
    for (;;) {
        const auto got = child.read(part, milliseconds(10000));
        if (!got || *got == 0) return text;
        text.append(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(*got));
    }
}

std::string whatItSays(const ChildPlan& plan) {
    ChildProcess child(plan);
    return readAll(child);
}

TEST(ChildProcess, TellsHowItEnded) {
    EXPECT_TRUE(ChildProcess(shell("exit 0")).wait().well());
    ChildProcess failed(shell("exit 3"));
    EXPECT_EQ(failed.wait().code(), 3);
    EXPECT_EQ(failed.wait().code(), 3) << "asked again";
    const ChildEnd killed = ChildProcess(shell("kill -TERM $$")).wait();
    EXPECT_EQ(killed.signal, SIGTERM);
    EXPECT_EQ(killed.code(), 128 + SIGTERM);
    EXPECT_FALSE(killed.well());
}

TEST(ChildProcess, TellsHowItEndedWhereTheParentIgnoresItsChildren) {
    const auto before = std::signal(SIGCHLD, SIG_IGN);
    EXPECT_EQ(ChildProcess(shell("exit 3")).wait().code(), 3);
    std::signal(SIGCHLD, before);
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    action.sa_flags = SA_NOCLDWAIT;
    sigaction(SIGCHLD, &action, nullptr);
    EXPECT_EQ(ChildProcess(shell("exit 4")).wait().code(), 4);
    std::signal(SIGCHLD, before);
}

TEST(ChildProcess, LeavesOtherChildrenToThoseWhoStartedThem) {
    const pid_t other = fork();
    if (other == 0) _exit(7);
    EXPECT_EQ(ChildProcess(shell("sleep 0.1; exit 2")).wait().code(), 2);
    int status = 0;
    ASSERT_EQ(waitpid(other, &status, 0), other);
    EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(ChildProcess, AnEndThatSomebodyElseTookIsNotAGoodOne) {
    ChildProcess child(shell("echo $$; exit 0"));
    const pid_t process = std::stoi(readAll(child));
    ASSERT_EQ(waitpid(process, nullptr, 0), process);
    EXPECT_FALSE(child.wait().well());
}

TEST(ChildProcess, HearsWhatItIsToldAndIsHeard) {
    ChildPlan plan = shell("cat; echo end");
    plan.input = ChildStream::kPiped;
    ChildProcess child(plan);
    const std::string words = "some words\n";
    EXPECT_FALSE(child.read(std::span<uint8_t>(), milliseconds(1))) << "nothing was said yet";
    EXPECT_TRUE(child.write({reinterpret_cast<const uint8_t*>(words.data()), words.size()}));
    child.closeInput();
    EXPECT_EQ(readAll(child), "some words\nend\n");
    EXPECT_TRUE(child.wait().well());
}

TEST(ChildProcess, WritingToOneThatHasGoneIsAnAnswerAndNoSignal) {
    ASSERT_EQ(std::signal(SIGPIPE, SIG_DFL), SIG_DFL);
    ChildPlan plan = shell("exit 0");
    plan.input = ChildStream::kPiped;
    ChildProcess child(plan);
    EXPECT_EQ(readAll(child), "");
    const std::vector<uint8_t> much(1 << 20);
    bool listens = true;
    for (int k = 0; listens && k < 1000; ++k) listens = child.write(much);
    EXPECT_FALSE(listens);
    EXPECT_TRUE(child.wait().well());
}

TEST(ChildProcess, EndsWithItsOwner) {
    pid_t process = 0;
    {
        ChildProcess child(shell("echo $$; exec sleep 1000 > /dev/null"));
        process = std::stoi(readAll(child));
        EXPECT_FALSE(child.waitUntil(ChildProcess::Clock::now() + milliseconds(20)));
        EXPECT_EQ(kill(process, 0), 0);
    }
    EXPECT_NE(kill(process, 0), 0) << "it still runs";
}

TEST(ChildProcess, WaitsNoLongerThanItIsTold) {
    ChildProcess child(shell("exit 5"));
    const auto end = child.waitUntil(ChildProcess::Clock::now() + std::chrono::minutes(1));
    ASSERT_TRUE(end);
    EXPECT_EQ(end->code(), 5);
}

TEST(ChildProcess, InheritsNoFileAndNoIgnoredSignal) {
    const int file = open("/dev/null", O_RDONLY);
    ASSERT_EQ(fcntl(file, F_GETFD), 0) << "not closed by exec alone";
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    const std::string said = whatItSays(shell("ls /proc/self/fd; grep SigIgn /proc/self/status"));
    std::signal(SIGPIPE, before);
    close(file);
    EXPECT_THAT(said, testing::StartsWith("0\n1\n2\n3\nSigIgn:")) << "3 is the folder that ls lists";
    const auto ignored = std::stoull(said.substr(said.find(':') + 1), nullptr, 16);
    EXPECT_EQ(ignored & (1ull << (SIGPIPE - 1)), 0u);
}

TEST(ChildProcess, WritesIntoASharedFileThatHasNoName) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
    ASSERT_TRUE(file);
    ChildPlan plan = shell(std::string("echo shared > ") + kSharedFile + "; ls /proc/self/fd | wc -l");
    plan.shares = fileno(file.get());
    EXPECT_EQ(whatItSays(plan), "5\n") << "three streams, the file, and the folder that ls lists";
    std::array<char, 8> text{};
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), file.get()), 7u);
    EXPECT_STREQ(text.data(), "shared\n");
}

TEST(ChildProcess, TakesVariablesInPlaceOfThoseOfTheEnvironment) {
    setenv("DEMOLISH_TEST_A", "old", 1);
    setenv("DEMOLISH_TEST_AB", "kept", 1);
    ChildPlan plan = shell("echo $DEMOLISH_TEST_A $DEMOLISH_TEST_AB; env | grep -c DEMOLISH_TEST_A=");
    plan.variables = {"DEMOLISH_TEST_A=new"};
    EXPECT_EQ(whatItSays(plan), "new kept\n1\n");
    unsetenv("DEMOLISH_TEST_A");
    unsetenv("DEMOLISH_TEST_AB");
}

TEST(ChildProcess, AProgramThatIsMissingIsAnError) {
    try {
        ChildProcess child({.words = {"no-such-program-anywhere"}});
        FAIL() << "started";
    } catch (const ChildError& error) {
        EXPECT_TRUE(error.is_missing);
        EXPECT_THAT(error.what(), HasSubstr("No such file"));
    }
}

}  // namespace
}  // namespace demolish
