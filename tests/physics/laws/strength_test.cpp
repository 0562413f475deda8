// SPDX-License-Identifier: Apache-2.0
// Scatter of strength and tough cells: means, reproducibility, shape of the labels.
#include "sim_cuda/physics/strength.h"

#include <gtest/gtest.h>

#include <set>

#include "sim_cuda/physics/tough_cells.h"

namespace demolish {
namespace {

TEST(CounterRandom, IsUniformAndDependsOnSeedAndIndexAlone) {
    double sum = 0, squares = 0;
    const int count = 100000;
    for (int k = 0; k < count; ++k) {
        const double u = uniformOf(9, uint64_t(k));
        ASSERT_GT(u, 0);
        ASSERT_LT(u, 1);
        sum += u;
        squares += u * u;
    }
    EXPECT_NEAR(sum / count, 0.5, 0.004);
    EXPECT_NEAR(squares / count, 1.0 / 3, 0.004);
    EXPECT_EQ(counterHash(4, 5), counterHash(4, 5));
    EXPECT_NE(counterHash(4, 5), counterHash(5, 4));
}

TEST(Weibull, HasMeanOneAndTheSpreadOfItsModulus) {  // A.4
    for (const double k : {3.0, 12.0}) {
        double sum = 0, squares = 0;
        const int count = 100000;
        for (int bond = 0; bond < count; ++bond) {
            const double s = weibullFactor(k, 42, uint64_t(bond));
            sum += s;
            squares += s * s;
        }
        const double mean = sum / count, variance = squares / count - mean * mean;
        const double expected = std::tgamma(1 + 2 / k) / std::pow(std::tgamma(1 + 1 / k), 2) - 1;
        EXPECT_NEAR(mean, 1, 0.005);
        EXPECT_NEAR(variance / expected, 1, 0.03);
    }
    EXPECT_EQ(weibullFactor(0, 42, 1), 1);
}

std::vector<Vec3<double>> lattice(int side) {
    std::vector<Vec3<double>> points;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) points.push_back({x * 0.05, y * 0.05, z * 0.05});
    return points;
}

TEST(ToughCells, EveryLabelIsUsedAndCellsHangTogether) {  // E.3
    const int side = 16;
    const auto points = lattice(side);
    const double volume = std::pow(side * 0.05, 3);
    const uint32_t cells = 40;
    const auto labels = toughCellLabels(points, volume, cells, 3);
    EXPECT_EQ(std::set<uint32_t>(labels.begin(), labels.end()).size(), cells);
    EXPECT_EQ(labels, toughCellLabels(points, volume, cells, 3));
    EXPECT_NE(labels, toughCellLabels(points, volume, cells, 4));
    size_t same = 0, pairs = 0;
    for (size_t k = 0; k + 1 < points.size(); ++k)
        if ((k + 1) % side != 0) {
            ++pairs;
            same += labels[k] == labels[k + 1];
        }
    // A cell is 4.7 particles across; cut planes take roughly 1.45/4.7 of the bonds of a Voronoi tiling of
    // that size.
    EXPECT_GT(double(same) / double(pairs), 0.55);
    EXPECT_LT(double(same) / double(pairs), 0.85);
}

TEST(ToughCells, NoiseShiftsWithinItsAmplitudeAndVariesSmoothly) {
    const double L = 0.2;
    double largest = 0, jump = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3<double> x{k * 1e-3, 0.1, -0.3};
        const auto shift = labelShift(x, L, 5), next = labelShift(x + Vec3<double>{1e-6, 0, 0}, L, 5);
        for (const double c : {shift.x, shift.y, shift.z}) largest = std::max(largest, std::abs(c));
        jump = std::max(jump, length(next - shift));
    }
    EXPECT_LE(largest, 0.25 * L);
    EXPECT_GT(largest, 0.08 * L);
    EXPECT_LT(jump, 1e-5);
}

TEST(ToughCells, NoCellsMeansOneLabelEachOrOneForAll) {
    const auto points = lattice(2);
    const auto all = toughCellLabels(points, 1, 100, 1);
    EXPECT_EQ(std::set<uint32_t>(all.begin(), all.end()).size(), points.size());
    const auto one = toughCellLabels(points, 1, 1, 1);
    EXPECT_EQ(std::set<uint32_t>(one.begin(), one.end()).size(), 1u);
}

}  // namespace
}  // namespace demolish
