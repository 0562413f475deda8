// SPDX-License-Identifier: Apache-2.0
// The meshes in assets/models, read back: closed, one part, no handle, exact counts, expected size.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "assets/models/surface.h"

namespace demolish::sculptor {
namespace {

struct Expected {
    const char* name;
    std::size_t triangles;
    double volume_m3, tolerance;
    double height_m;
};

void PrintTo(const Expected& expected, std::ostream* out) {
    *out << expected.name;
}

/// Six times the signed volume of a tetrahedron.
double side(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
    return dot(cross(b - a, c - a), p - a);
}

/// True when the open segment crosses the inside of the triangle; shared corners and edges do not count.
bool crosses(Vec3 p, Vec3 q, Vec3 a, Vec3 b, Vec3 c) {
    if (side(a, b, c, p) * side(a, b, c, q) >= 0) return false;
    const double x = side(p, q, a, b), y = side(p, q, b, c), z = side(p, q, c, a);
    return (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);
}

/// Triangles with their boxes, rising by the box's low z, so that only near ones are compared.
struct Boxed {
    std::array<Vec3, 3> corners;
    Vec3 low, high;
};

std::vector<Boxed> boxed(const Surface& mesh) {
    std::vector<Boxed> all;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        all.push_back({{a, b, c},
                       {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                       {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
    }
    std::sort(all.begin(), all.end(), [](const Boxed& l, const Boxed& r) { return l.low.z < r.low.z; });
    return all;
}

bool intersect(const Boxed& s, const Boxed& t) {
    if (t.low.x > s.high.x || t.high.x < s.low.x || t.low.y > s.high.y || t.high.y < s.low.y) return false;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (crosses(s.corners[i], s.corners[j], t.corners[0], t.corners[1], t.corners[2])) return true;
        if (crosses(t.corners[i], t.corners[j], s.corners[0], s.corners[1], s.corners[2])) return true;
    }
    return false;
}

class CommittedMesh : public testing::TestWithParam<Expected> {
  protected:
    void SetUp() override {
        std::ifstream in(std::string(DEMOLISH_SOURCE_DIR "/assets/models/") + GetParam().name);
        ASSERT_TRUE(in) << GetParam().name;
        for (std::string line; std::getline(in, line);) read(line);
    }

    void read(const std::string& line) {
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword == "vn") ++normals_;
        if (keyword == "vt") ++uvs_;
        if (keyword == "v") {
            Vec3 p;
            ASSERT_TRUE(words >> p.x >> p.y >> p.z);
            mesh_.positions.push_back(p);
        }
        if (keyword == "f") {
            Triangle triangle;
            for (std::uint32_t& v : triangle) {
                std::size_t position = 0, uv = 0, normal = 0;
                char slash;
                ASSERT_TRUE(words >> position >> slash >> uv >> slash >> normal);
                ASSERT_TRUE(position >= 1 && uv >= 1 && uv <= uvs_ && normal >= 1 && normal <= normals_);
                v = static_cast<std::uint32_t>(position - 1);
            }
            mesh_.triangles.push_back(triangle);
        }
    }

    Surface mesh_;
    std::size_t normals_ = 0, uvs_ = 0;
};

TEST_P(CommittedMesh, IsClosedWithExactCounts) {
    EXPECT_EQ(mesh_.triangles.size(), GetParam().triangles);
    EXPECT_EQ(mesh_.positions.size(), GetParam().triangles / 2 + 2);
    const Topology topology = topologyOf(mesh_);
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.euler, 2);
    EXPECT_EQ(topology.parts, 1);
}

TEST_P(CommittedMesh, HasItsSizeAndStandsOnTheGround) {
    EXPECT_NEAR(volumeOf(mesh_), GetParam().volume_m3, GetParam().tolerance * GetParam().volume_m3);
    double low = 1e9, high = -1e9;
    for (const Vec3 p : mesh_.positions) low = std::min(low, p.y), high = std::max(high, p.y);
    EXPECT_EQ(low, 0);
    EXPECT_NEAR(high, GetParam().height_m, 0.02 * GetParam().height_m);
}

TEST_P(CommittedMesh, HasNoTriangleWithoutArea) {
    for (const Triangle& t : mesh_.triangles) {
        double longest = 0;
        for (int i = 0; i < 3; ++i)
            longest = std::max(longest, length(mesh_.positions[t[(i + 1) % 3]] - mesh_.positions[t[i]]));
        // Height over the longest side: half a percent of it at least.
        EXPECT_GT(length(areaNormal(mesh_, t)) / longest, 0.005 * longest);
    }
}

TEST_P(CommittedMesh, DoesNotCutItself) {
    const auto triangles = boxed(mesh_);
    std::size_t cuts = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = i + 1; j < triangles.size() && triangles[j].low.z <= triangles[i].high.z; ++j)
            cuts += intersect(triangles[i], triangles[j]);
    EXPECT_EQ(cuts, 0u);
}

TEST(CutTest, SeesACut) {
    const Surface crossed{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {3, 3, 0}},
                          {{0, 1, 2}, {3, 4, 5}}};
    const auto triangles = boxed(crossed);
    EXPECT_TRUE(intersect(triangles[0], triangles[1]));
}

INSTANTIATE_TEST_SUITE_P(Models, CommittedMesh,
                         testing::Values(Expected{"rabbit_paper.obj", 592, 4.994e-3, 0.01, 0.345},
                                         Expected{"rabbit.obj", 20000, 4.994e-3, 0.03, 0.345},
                                         Expected{"vase_paper.obj", 3000, 5.950e-3, 0.01, 0.504},
                                         Expected{"vase.obj", 19872, 5.950e-3, 0.05, 0.504},
                                         Expected{"column_paper.obj", 674, 0.319, 0.002, 2.3},
                                         Expected{"column.obj", 20160, 0.319, 0.01, 2.3},
                                         Expected{"tumbler.obj", 5920, 3.68e-4, 0.01, 0.153},
                                         Expected{"dish.obj", 5568, 6.43e-4, 0.01, 0.037},
                                         Expected{"wrecking_ball.obj", 1200, 0.0340, 0.01, 0.48},
                                         Expected{"wolf_paper.obj", 18724, 0.106, 0.01, 1.05},
                                         Expected{"wolf.obj", 60000, 0.106, 0.01, 1.05}),
                         [](const auto& test) {
                             return std::filesystem::path(test.param.name).stem().string();
                         });

}  // namespace
}  // namespace demolish::sculptor
