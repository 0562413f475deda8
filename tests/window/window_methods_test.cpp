// SPDX-License-Identifier: Apache-2.0
// The methods of the paper's comparison in the window: chosen from the panel, switched while the shot runs,
// recorded and scrubbed.
#include <gtest/gtest.h>

#include "engine/image/compare.h"
#include "engine/image/png.h"
#include "tests/window/window_program.h"

namespace demolish::test {
namespace {

std::string choose(const std::string& method) {
    return "click method\nclick method." + method + "\nwait 2\nuntil rebuilt\nwait 2\n";
}

/// A method from the list, played until the block has been hit, and scrubbed back to the start.
std::string playAndScrub(const std::string& method) {
    std::string script = choose(method) + "key r\nwait 2\n";
    const auto look = [&](const std::string& when) {
        script += "state " + method + "_" + when + "\nscreenshot 18_" + method + "_" + when + "\n";
    };
    look("before");
    script += "key space\nwait 60\nkey space\nwait 2\n";
    look("broken");
    script += "set transport.timeline 0.02\nwait 2\n";
    look("scrubbed");
    return script;
}

class WindowMethods : public WindowProgram {
  protected:
    double likeness(const std::string& method, const char* a, const char* b) const {
        const auto picture = [&](const char* when) {
            return engine::readPng(screenshot("18_" + method + "_" + when));
        };
        return engine::compare(picture(a), picture(b)).ssim;
    }
    void expectBrokeAndCameBack(const std::string& method) const {
        const auto before = read(method + "_before"), broken = read(method + "_broken"),
                   scrubbed = read(method + "_scrubbed");
        EXPECT_EQ(before["method"], method);
        EXPECT_EQ(before["bonds_broken"], 0) << method;
        EXPECT_GT(broken["bonds_broken"].get<int>(), 0) << method;
        EXPECT_EQ(scrubbed["replaying"], true) << method;
        EXPECT_EQ(scrubbed["bonds_broken"], 0) << method;
        for (const auto& state : {before, broken, scrubbed}) EXPECT_EQ(state["message"], "") << method;
        EXPECT_GT(likeness(method, "before", "scrubbed"), likeness(method, "before", "broken")) << method;
    }
};

TEST_F(WindowMethods, AreRecordedAndScrubbed) {
    const std::vector<std::string> methods{"pattern", "pattern-at-impact", "cores", "heavy", "ours"};
    std::string script = "wait 2\nkey space\nclick transport.real_time\n";
    for (const std::string& method : methods) script += playAndScrub(method);
    run(script, {"--impact-velocity", "60"}, 120);
    if (HasFatalFailure()) return;
    for (const std::string& method : methods) expectBrokeAndCameBack(method);
}

TEST_F(WindowMethods, SwitchWhileTheShotRuns) {
    const std::vector<std::string> methods{"heavy", "cores", "pattern"};
    std::string script = "click transport.real_time\nwait 10\nstate ours\n";
    for (const std::string& method : methods) script += choose(method) + "state " + method + "\n";
    script += "click pattern\nclick pattern.bricks\nwait 2\nuntil rebuilt\nwait 2\nkey space\nstate bricks\n";
    script += "set transport.timeline 0.0\nwait 2\nstate scrubbed\n";
    run(script, {}, 120);
    if (HasFatalFailure()) return;
    EXPECT_EQ(read("ours")["method"], "ours");
    for (const std::string& method : methods) {
        EXPECT_EQ(read(method)["method"], method);
        EXPECT_EQ(read(method)["particles"], read("ours")["particles"]) << "the same cells";
    }
    EXPECT_EQ(read("scrubbed")["bonds_broken"], 0);
    for (const char* name : {"heavy", "cores", "pattern", "bricks", "scrubbed"})
        EXPECT_EQ(read(name)["message"], "") << name;
}

}  // namespace
}  // namespace demolish::test
