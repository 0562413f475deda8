// SPDX-License-Identifier: Apache-2.0
// The curve as a drawing: areas that add up to the frame times, phases in their places, words escaped.
#include "app/commands/frame_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

#include "app/commands/svg_writer.h"

namespace demolish {
namespace {

using testing::HasSubstr;

std::vector<FrameSample> samples() {
    std::vector<FrameSample> all(60);
    for (size_t i = 0; i < all.size(); ++i) {
        all[i] = {i < 30 ? 4.0 : 10.0, i < 30 ? 2.0 : 7.0, 1.0, 0.5};
        all[i].stats.time = static_cast<double>(i + 1) / 60;
        all[i].stats.fracture_changed = i == 30 || i == 31;
        all[i].stats.awake_particles = i < 30 ? 0 : 900;
        all[i].stats.bonded_particles = i < 30 ? 0 : 500;
    }
    return all;
}

const std::vector<Phase> kPhases{{"whole", 0, 0.5, 280}, {"all broken", 0.5, 1, 0}};

/// Area in px^2 of the polygon with this colour.
double areaOf(const std::string& svg, const std::string& colour) {
    std::smatch match;
    const std::regex polygon("<polygon points=\"([^\"]*)\" fill=\"" + colour + "\"/>");
    if (!std::regex_search(svg, match, polygon)) return -1;
    std::vector<SvgPoint> points;
    std::istringstream words(match[1].str());
    for (std::string word; words >> word;) {
        const size_t comma = word.find(',');
        points.push_back({std::stod(word.substr(0, comma)), std::stod(word.substr(comma + 1))});
    }
    double twice = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        const SvgPoint &a = points[i], &b = points[(i + 1) % points.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}

TEST(FrameCurve, EachStagesAreaIsItsTime) {
    const std::string svg = frameCurveSvg(samples(), kPhases, "bunny", "CPU");
    // Over the shot: simulation 4.5 ms in the mean, transfer 0.5, drawing 1, rest 1.
    const double sim = areaOf(svg, "#e8913a"), transfer = areaOf(svg, "#7b5ea7"),
                 draw = areaOf(svg, "#4a90d9"), rest = areaOf(svg, "#b4b8be");
    EXPECT_GT(transfer, 100);
    EXPECT_NEAR(sim / transfer, 9, 0.02);
    EXPECT_NEAR(draw / transfer, 2, 0.01);
    EXPECT_NEAR(rest / transfer, 2, 0.01);
    EXPECT_NEAR(areaOf(svg, "#4f9d69") / areaOf(svg, "#a9d18e"), 500.0 / 400, 0.01);
}

TEST(FrameCurve, PhasesAxesAndBreaksAreNamed) {
    const std::string svg = frameCurveSvg(samples(), kPhases, "bunny: 1 < 2 & 3", "CPU");
    EXPECT_THAT(svg, HasSubstr("bunny: 1 &lt; 2 &amp; 3"));
    EXPECT_THAT(svg, HasSubstr(">whole<"));
    EXPECT_THAT(svg, HasSubstr(">250.0 FPS<"));
    EXPECT_THAT(svg, HasSubstr(">paper 280<"));
    EXPECT_THAT(svg, HasSubstr(">100.0 FPS<"));
    EXPECT_THAT(svg, HasSubstr("ms per frame"));
    EXPECT_THAT(svg, HasSubstr("simulated time, s"));
    EXPECT_THAT(svg, HasSubstr("240 FPS"));
    const std::regex tick("height=\"8.00\" fill=\"#c0202a\"");
    EXPECT_EQ(std::distance(std::sregex_iterator(svg.begin(), svg.end(), tick), {}), 2);
}

TEST(FrameCurve, AShotThatFailedAtOnceIsStillADrawing) {
    EXPECT_THAT(frameCurveSvg({}, kPhases, "bunny", ""), testing::EndsWith("</svg>\n"));
    const auto all = samples();
    EXPECT_THAT(frameCurveSvg(std::span(all).first(1), {}, "", ""), testing::Not(HasSubstr("nan")));
}

TEST(FrameCurve, TicksAreRoundNumbers) {
    EXPECT_DOUBLE_EQ(tickStep(10, 10), 1);
    EXPECT_DOUBLE_EQ(tickStep(10, 6), 2);
    EXPECT_DOUBLE_EQ(tickStep(0.37, 4), 0.1);
    EXPECT_DOUBLE_EQ(tickStep(4000, 6), 1000);
    EXPECT_DOUBLE_EQ(tickStep(4.1, 1), 5);
}

}  // namespace
}  // namespace demolish
