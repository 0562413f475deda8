// SPDX-License-Identifier: Apache-2.0
// The window's measurement: beside the thread that draws, and cancelled at once.
#include "app/calibrate/calibration_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "app/session/scene_file.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish {
namespace {

class Worker : public testing::Test {
  protected:
    void SetUp() override {
        setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
        shot_ = loadScene("block");
        shot_.fineness.particles = 150;
        shot_.device = DeviceChoice::kCpu;
        shot_.impact.kind = ImpactKind::kDrop;
        body_ =
            fillPackings(shot_, *loadSolidMesh(shot_.model, {.height = shot_.height}), 1, false, {}).at(0);
    }
    void TearDown() override { unsetenv("XDG_CACHE_HOME"); }
    static void waitFor(const CalibrationWorker& worker) {
        while (worker.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    test::TemporaryFolder folder_;
    Shot shot_;
    std::shared_ptr<const BreakableBody> body_;
};

TEST_F(Worker, BringsTheThresholdOnce) {
    CalibrationWorker worker;
    EXPECT_FALSE(worker.take());
    worker.start(shot_, body_);
    waitFor(worker);
    const auto found = worker.take();
    ASSERT_TRUE(found);
    EXPECT_NEAR(thresholdOf(shot_, *body_)->measured.value(), found->velocity(), 1e-9);
    EXPECT_FALSE(worker.take());
}

TEST_F(Worker, ACancelledOneBringsNothing) {
    CalibrationWorker worker;
    worker.start(shot_, body_);
    worker.cancel();
    waitFor(worker);
    EXPECT_FALSE(worker.take());
}

TEST_F(Worker, CancelledInTheLastTrialKeepsNothing) {
    int told = 0;
    const auto until = [&](int last) {
        told = 0;
        return [&told, last](double, const char*) { return ++told != last; };
    };
    calibrate(shot_, body_, {.use_cache = false}, until(-1));
    const int all = told;
    EXPECT_THROW(calibrate(shot_, body_, {}, until(all)), Cancelled);
    EXPECT_FALSE(thresholdOf(shot_, *body_)->measured);
    calibrate(shot_, body_, {}, until(all + 1));
    EXPECT_TRUE(thresholdOf(shot_, *body_)->measured);
}

TEST_F(Worker, AnErrorComesOutWhereTheResultWould) {
    shot_.impact.kind = ImpactKind::kNone;
    CalibrationWorker worker;
    worker.start(shot_, body_);
    waitFor(worker);
    EXPECT_THROW(worker.take(), UsageError);
    EXPECT_FALSE(worker.take());
}

}  // namespace
}  // namespace demolish
