// SPDX-License-Identifier: Apache-2.0
// Times of the substep as table, JSON and CSV.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/kernel_bench.h"
#include "app/commands/text_table.h"

namespace demolish {
namespace {

using testing::HasSubstr;

const KernelPlace kPlace{"NVIDIA H200", "NVIDIA 580", "some processor, 2 GHz", "0.1.0", 16};

std::vector<KernelRow> rows() {
    KernelRow measured;
    measured.particles = 10648;
    measured.bonds = 59598;
    measured.intact_us = 8;
    measured.shattering_us = 10;
    measured.shattering_broken = 1234;
    measured.broken_us = 12;
    measured.broken_broken = 59598;
    measured.floor.memory_us = 1;
    measured.floor.copy_bandwidth = 4.2e12;
    measured.floor.schemes = {{"graph, 4 threads", 5}, {"resident, 8 threads", 4}};
    measured.floor.bonds_us = 4;
    KernelRow unfloored = measured;
    unfloored.floor = {};
    unfloored.particles = 2197;
    unfloored.broken_broken = 100;
    return {measured, unfloored};
}

TEST(KernelReport, TheTableGivesTheSharesOfTheFloors) {
    const std::string table = kernelTable(rows(), kPlace);
    EXPECT_THAT(table,
                testing::ContainsRegex("10648 +59598 +8.00 +4.00 +50 % +1.00 +12 % +10.00 +1234 +12.00"));
    EXPECT_THAT(table, testing::ContainsRegex("2197 +59598 +8.00 +- +- +0.00 +-"));
    EXPECT_THAT(table, HasSubstr("floor of bonds at 10648: resident, 8 threads"));
    EXPECT_THAT(table, HasSubstr("at 2197 only 100 bonds broke"));
    EXPECT_THAT(table, HasSubstr("4200 GB/s"));
}

TEST(KernelReport, JsonKeepsEverySchemeAndNullWithoutAFloor) {
    const auto json = nlohmann::json::parse(kernelJson(rows(), kPlace));
    EXPECT_EQ(json["device"], "NVIDIA H200");
    EXPECT_EQ(json["rows"][0]["floor_bonds_us"], 4);
    EXPECT_EQ(json["rows"][0]["floor_schemes_us"].size(), 2u);
    EXPECT_TRUE(json["rows"][1]["floor_bonds_us"].is_null());
}

TEST(KernelReport, CsvNamesTheBestScheme) {
    const std::string csv = kernelCsv(rows(), kPlace);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
    EXPECT_THAT(csv, HasSubstr("\"some processor, 2 GHz\",16,0.1.0,10648,59598,8,10,1234,12,59598,4,"
                               "\"resident, 8 threads\",1,4.2e+12"));
}

TEST(TextTable, FieldsAreQuotedWhereTheyMust) {
    EXPECT_EQ(csvLine({"a", "b c", ""}), "a,b c,\n");
    EXPECT_EQ(csvLine({"1,5", "he said \"no\""}), "\"1,5\",\"he said \"\"no\"\"\"\n");
    EXPECT_EQ(csvLine({"", "x"}), ",x\n");
    EXPECT_EQ(formatted("%5.1f|%d", 2.25, 7), "  2.2|7");
}

}  // namespace
}  // namespace demolish
