// SPDX-License-Identifier: Apache-2.0
// Contact spheres of bodies that stand close to each other.
#include <gtest/gtest.h>

#include "sim_cuda/solver/scene_tables.h"

namespace demolish::tests {
namespace {

struct Sphere {
    uint32_t body = 0;
    Vec3<double> at;
    double radius = 0;
};

SceneTables tablesOf(uint32_t bodies, const std::vector<Sphere>& spheres) {
    SceneTables tables;
    tables.bodies = bodies;
    for (const Sphere& sphere : spheres) {
        tables.owner.push_back(sphere.body);
        tables.position.push_back(sphere.at);
        tables.contact_radius.push_back(sphere.radius);
        tables.largest_radius = std::max(tables.largest_radius, sphere.radius);
    }
    return tables;
}

TEST(CloseBodies, SpheresOfTwoBodiesThatOverlapJustTouch) {
    SceneTables tables = tablesOf(2, {{0, {0, 0, 0}, 3}, {1, {2, 0, 0}, 1}, {1, {9, 0, 0}, 1}});
    keepBodiesApart(tables);
    EXPECT_DOUBLE_EQ(tables.contact_radius[0], 1.5);
    EXPECT_DOUBLE_EQ(tables.contact_radius[1], 0.5);
    EXPECT_EQ(tables.contact_radius[2], 1) << "far from the other body";
    EXPECT_DOUBLE_EQ(tables.largest_radius, 1.5);
}

TEST(CloseBodies, SpheresOfOneBodyStayAsTheyAre) {
    SceneTables tables = tablesOf(2, {{0, {0, 0, 0}, 1}, {0, {1, 0, 0}, 1}, {1, {0, 5, 0}, 1}});
    keepBodiesApart(tables);
    EXPECT_EQ(tables.contact_radius, (std::vector<double>{1, 1, 1}));
}

TEST(CloseBodies, NoTwoOverlapWhoeverIsNearestToWhom) {
    std::vector<Sphere> spheres;
    for (int k = 0; k < 60; ++k)
        spheres.push_back({static_cast<uint32_t>(k % 3),
                           {0.37 * (k * 7 % 11), 0.41 * (k * 5 % 13), 0.43 * (k * 3 % 7)},
                           0.2 + 0.01 * (k % 17)});
    SceneTables tables = tablesOf(3, spheres);
    keepBodiesApart(tables);
    for (size_t i = 0; i < spheres.size(); ++i)
        for (size_t j = 0; j < i; ++j) {
            const double apart = length(spheres[j].at - spheres[i].at);
            if (spheres[i].body == spheres[j].body || apart < 0.05) continue;
            EXPECT_LE(tables.contact_radius[i] + tables.contact_radius[j], apart * (1 + 1e-12));
        }
}

}  // namespace
}  // namespace demolish::tests
