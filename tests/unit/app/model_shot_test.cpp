// SPDX-License-Identifier: Apache-2.0
// What is said of a model's size, to whom.
#include "app/session/model_shot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demolish {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string remark(const std::string& model, double unit, double longest, Advised advised) {
    Shot shot;
    shot.model = model;
    setUnit(shot, unit);
    return sizeRemark(shot, {0, 0, 0}, {longest, longest / 2, longest / 2}, advised);
}

TEST(ModelShot, ASizeRemarkNamesWhatItsReaderHas) {
    const auto window = Advised::kWindow, terminal = Advised::kTerminal;
    EXPECT_THAT(remark("a.obj", 0, 1, terminal), HasSubstr("--unit m, cm, mm, in or ft keeps"));
    EXPECT_THAT(remark("a.obj", 0, 1, window), AllOf(HasSubstr("'Unit of the file'"), Not(HasSubstr("--"))));
    EXPECT_THAT(remark("a.obj", 0.001, 0.002, terminal),
                AllOf(HasSubstr("0.002 m long"), HasSubstr("another --unit"), HasSubstr("--height")));
    EXPECT_THAT(remark("a.obj", 0.001, 0.002, window),
                AllOf(HasSubstr("'Unit of the file'"), HasSubstr("'Model height'"), Not(HasSubstr("--"))));
    EXPECT_THAT(remark("a.glb", 0, 300, terminal),
                AllOf(HasSubstr("unit of its export"), Not(HasSubstr("--unit"))))
        << "it says its unit itself";
    EXPECT_THAT(remark("a.glb", 0, 300, window),
                AllOf(HasSubstr("unit of its export"), Not(HasSubstr("--")), Not(HasSubstr("Unit of"))));
    EXPECT_EQ(remark("a.glb", 0, 3, window), "");
}

}  // namespace
}  // namespace demolish
