// SPDX-License-Identifier: Apache-2.0
// The benchmark's rows as table, JSON and CSV: the numbers that were summed up, and nothing where there are
// none.
#include "app/commands/phase_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

namespace demolish {
namespace {

using testing::HasSubstr;

/// 40 frames at 2 ms, of which the last breaks bonds; a phase of 20 frames, one that is never reached.
std::vector<PhaseSummary> rows() {
    std::vector<FrameSample> samples(40);
    for (size_t i = 0; i < samples.size(); ++i) {
        samples[i] = {2.0, 1.25, 0.5, 0.125};
        samples[i].triangles = 1234567;
        FrameStats& stats = samples[i].stats;
        stats.time = static_cast<double>(i + 1) / 60;
        stats.particles = 80000;
        stats.awake_particles = 4000;
        stats.bonded_particles = 3000;
        stats.awake_bodies = 2;
        stats.fragments = 321;
        stats.substeps = 417;
        stats.fracture_changed = i + 1 == samples.size();
    }
    const std::vector<Phase> phases{{"some broken", 0, 20.0 / 60, 155}, {"all broken", 9, 10, 40}};
    return summarisePhases(samples, phases);
}

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

TEST(PhaseReport, TheTableSetsThePapersRateBesideOurs) {
    const std::string table = phaseTable(rows(), 20);
    const auto lines = linesOf(table);
    EXPECT_THAT(wordsOf(lines[2]), testing::ElementsAre("some", "broken", "20", "500.0", "500.0", "155",
                                                        "3.23", "500.0", "2.00", "2.00"));
    EXPECT_THAT(wordsOf(lines[3]),
                testing::ElementsAre("all", "broken", "0", "-", "-", "40", "-", "-", "-", "-"));
    EXPECT_THAT(wordsOf(lines[4]), testing::ElementsAre("while", "it", "breaks", "1", "500.0", "500.0", "-",
                                                        "-", "500.0", "2.00", "2.00"));
    EXPECT_THAT(wordsOf(lines[5]),
                testing::ElementsAre("breaking", "1", "500.0", "500.0", "-", "-", "500.0", "2.00", "2.00"));
    EXPECT_THAT(table, HasSubstr("4000 / 80000"));
    EXPECT_THAT(table, HasSubstr("2 / 20"));
    for (const auto& line : lines) EXPECT_LE(line.size(), 110u) << line;
}

TEST(PhaseReport, JsonHasTheSameNumbersAndNullWhereThereIsNone) {
    const auto json = phaseJson(rows(), 20);
    ASSERT_EQ(json.size(), 5u);
    EXPECT_EQ(json[0]["phase"], "some broken");
    EXPECT_EQ(json[0]["frames"], 20);
    EXPECT_DOUBLE_EQ(json[0]["fps_median"].get<double>(), 500);
    EXPECT_DOUBLE_EQ(json[0]["fps_mean"].get<double>(), 500);
    EXPECT_DOUBLE_EQ(json[0]["ratio"].get<double>(), 500.0 / 155);
    EXPECT_DOUBLE_EQ(json[0]["sim_ms"].get<double>(), 1.25);
    EXPECT_DOUBLE_EQ(json[0]["draw_ms"].get<double>(), 0.5);
    EXPECT_DOUBLE_EQ(json[0]["transfer_ms"].get<double>(), 0.125);
    EXPECT_DOUBLE_EQ(json[0]["rest_ms"].get<double>(), 0.125);
    EXPECT_EQ(json[0]["bodies"], 20);
    EXPECT_EQ(json[0]["triangles"], 1234567);
    EXPECT_EQ(json[0]["fragments"], 321);
    EXPECT_EQ(json[1]["frames"], 0);
    EXPECT_TRUE(json[1]["fps_median"].is_null());
    EXPECT_TRUE(json[1]["ratio"].is_null());
    EXPECT_EQ(json[1]["paper_fps"], 40);
    EXPECT_TRUE(json[2]["paper_fps"].is_null());
}

/// Splits a line whose quoted fields hold no quotes.
std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            fields.emplace_back();
        else
            fields.back() += c;
    }
    return fields;
}

TEST(PhaseReport, CsvLinesHaveOneFieldForEachName) {
    const auto lines =
        linesOf(phaseCsv(rows(), 20, {{"scene", "vase"}, {"gl_renderer", "llvmpipe (LLVM, 256 bits)"}}));
    ASSERT_EQ(lines.size(), 6u);
    const auto names = fieldsOf(lines[0]);
    EXPECT_EQ(names[0], "scene");
    EXPECT_EQ(names[2], "phase");
    for (const auto& line : lines) EXPECT_EQ(fieldsOf(line).size(), names.size()) << line;
    const auto values = fieldsOf(lines[1]);
    EXPECT_EQ(values[1], "llvmpipe (LLVM, 256 bits)");
    const auto field = [&](const std::string& name) {
        return values.at(static_cast<size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
    };
    EXPECT_EQ(field("fps_median"), "500");
    EXPECT_EQ(field("ratio"), "3.22581");
    EXPECT_EQ(field("triangles"), "1234567");
    EXPECT_EQ(fieldsOf(lines[2])[6], "") << "no FPS where no frame was timed";
}

}  // namespace
}  // namespace demolish
