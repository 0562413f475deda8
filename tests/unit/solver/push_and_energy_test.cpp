// SPDX-License-Identifier: Apache-2.0
// What a cell gets from a shape is the slope of what its springs hold there, also across edges, where its
// corners are pushed along different normals: else energy comes from nowhere. Forces and torques beside
// differences of that energy between places and turns close by.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "sim_cuda/kernels/press_on_shape.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::tests {
namespace {

struct Cell {
    std::vector<Vec4<double>> corners;
    double inner_radius = 0;  // m
    Vec3<double> at;          // m
    Quat<double> turned;
};

/// Corners and place at random, so that many lie across the edges of something of half a metre.
class RandomCells {
  public:
    Cell next(double inner_radius) {
        Cell cell{{}, inner_radius, {0.6 * one(), 0.6 * one(), 0.6 * one()}, {}};
        for (int k = 0; k < 12; ++k) cell.corners.push_back({0.1 * one(), 0.1 * one(), 0.1 * one(), 0});
        cell.turned = normalized(Quat<double>{one(), one(), one(), one()});
        return cell;
    }

  private:
    double one() { return uniform_(random_); }
    std::mt19937 random_{11};
    std::uniform_real_distribution<double> uniform_{-1, 1};
};

Pressed<double> pressed(const ColliderSet<double>& set, const Cell& cell) {
    OwnParticle<double> own;
    own.state.position = withW(cell.at, 0.0);
    own.state.rotation = {cell.turned.x, cell.turned.y, cell.turned.z, cell.turned.w};
    const SeenCell<double> seen{
        {{cell.corners.data(), cell.corners.size()}, cell.inner_radius}, cell.turned, 0};
    const auto points =
        cornersOnShape<false, false, double>(set.collider[0], poseOf(own, seen), LaneGroup<1>{});
    return pressedOnShape<false, false>(points.points, own, seen, set.tangent(0, cell.at));
}
double push(const Pressed<double>& at) {
    return at.springs * at.depth;
}
double energy(const ColliderSet<double>& set, const Cell& cell) {
    const Pressed<double> at = pressed(set, cell);
    return 0.5 * push(at) * at.depth;
}

constexpr double kStep = 1e-7;  // m, and radians

/// Of the energy, along an axis from -kStep to kStep.
double slopeAlong(const ColliderSet<double>& set, Cell cell, const Vec3<double>& axis) {
    const Vec3<double> at = cell.at;
    cell.at = axpy(kStep, axis, at);
    const double after = energy(set, cell);
    cell.at = axpy(-kStep, axis, at);
    return (after - energy(set, cell)) / (2 * kStep);
}
double slopeAbout(const ColliderSet<double>& set, Cell cell, const Vec3<double>& axis) {
    const Quat<double> turned = cell.turned;
    const auto turn = [&](double by) {
        return multiply({0.5 * by * axis.x, 0.5 * by * axis.y, 0.5 * by * axis.z, 1}, turned);
    };
    cell.turned = turn(kStep);
    const double after = energy(set, cell);
    cell.turned = turn(-kStep);
    return (after - energy(set, cell)) / (2 * kStep);
}

/// `across`: of the cells that touch at least so many lie across an edge.
void expectSlopes(const Collider& collider, double inner_radius, int across) {
    const auto set = makeColliderSet<double>({collider});
    RandomCells cells;
    int touching = 0, over_edges = 0;
    for (int k = 0; k < 2000; ++k) {
        SCOPED_TRACE(k);
        const Cell cell = cells.next(inner_radius);
        const Pressed<double> at = pressed(set, cell);
        if (!(at.depth > 0)) continue;
        ++touching;
        over_edges += length(at.couple) > 1e-3;
        const Vec3<double> force = push(at) * at.normal,
                           torque = push(at) * (cross(at.arm, at.normal) + at.couple);
        const double full = 0.2 * 12 * 0.1;  // of twelve corners a decimetre deep
        for (const Vec3<double>& axis : {Vec3<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
            EXPECT_NEAR(dot(force, axis), -slopeAlong(set, cell, axis), 1e-5 * full);
            EXPECT_NEAR(dot(torque, axis), -slopeAbout(set, cell, axis), 1e-6 * full);
        }
    }
    EXPECT_GT(touching, 300);
    EXPECT_GE(over_edges, across);
}

TEST(Push, OnABoxIsTheSlopeOfWhatSpringsHold) {
    expectSlopes(Box{{0.8, 0.7, 0.9}, {0.1, 0, 0}, {0.1, 0.2, 0.3, 0.92736185}}, 0.05, 200);
}
TEST(Push, OnACapsuleIsTheSlopeOfWhatSpringsHold) {
    expectSlopes(Capsule{0.3, {-0.3, 0, 0}, {0.3, 0.1, 0}}, 0.05, 100);
}
TEST(Push, OnAMeshIsTheSlopeOfWhatSpringsHold) {
    const auto mesh = makeColliderMesh(test::makeCube(0.7), "test.obj", {.repair = {}, .cells = 48});
    expectSlopes(MeshShape{mesh, 1, {}, {0.1, 0.2, 0.3, 0.92736185}}, -1, 200);
}

}  // namespace
}  // namespace demolish::tests
