// SPDX-License-Identifier: Apache-2.0
// Makes the closed test meshes: cube, torus, sphere, vase.
#include "tests/unit/meshes/mesh_makers.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "sim_cuda/authoring/double3.h"

namespace demolish::test {
namespace {

using Triangle = std::array<uint32_t, 3>;
constexpr double kTurn = 2 * std::numbers::pi;

void fillCorners(TriangleMesh& mesh) {
    mesh.corners.clear();
    for (const Triangle& t : mesh.triangles) {
        const Double3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
        const Double3 n = normalized(cross(b - a, c - a));
        const Float3 normal{float(n.x), float(n.y), float(n.z)};
        std::array<CornerAttributes, 3> corners;
        for (int k = 0; k < 3; ++k) {
            const Double3& p = mesh.positions[t[k]];
            corners[k] = {normal, {float(p.x + p.z), float(p.y)}};
        }
        mesh.corners.push_back(corners);
    }
}

/// A quad a b c d, counter-clockwise seen from outside.
void addQuad(TriangleMesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

/// Second derivatives of the natural cubic spline through (x, y).
template <size_t N>
std::array<double, N> splineCurvatures(const std::array<double, N>& x, const std::array<double, N>& y) {
    std::array<double, N> curvature{}, upper{};
    for (size_t i = 1; i + 1 < N; ++i) {
        const double left = x[i] - x[i - 1], right = x[i + 1] - x[i];
        const double slope_change = (y[i + 1] - y[i]) / right - (y[i] - y[i - 1]) / left;
        const double pivot = 2 * (left + right) - left * upper[i - 1];
        upper[i] = right / pivot;
        curvature[i] = (6 * slope_change - left * curvature[i - 1]) / pivot;
    }
    for (size_t i = N - 2; i > 0; --i) curvature[i] -= upper[i] * curvature[i + 1];
    return curvature;
}

double vaseRadius(double fraction) {
    static constexpr std::array<double, 10> kFraction{0, .04, .09, .20, .38, .52, .68, .80, .90, 1};
    static constexpr std::array<double, 10> kRadius{.085, .095, .075, .125, .172,
                                                    .165, .105, .070, .078, .115};
    static const auto curvature = splineCurvatures(kFraction, kRadius);
    size_t i = 0;
    while (i + 2 < kFraction.size() && fraction > kFraction[i + 1]) ++i;
    const double step = kFraction[i + 1] - kFraction[i];
    const double b = (fraction - kFraction[i]) / step, a = 1 - b;
    return a * kRadius[i] + b * kRadius[i + 1] +
           ((a * a * a - a) * curvature[i] + (b * b * b - b) * curvature[i + 1]) * step * step / 6;
}

/// The recipe's list of ring heights, re-sampled when another number of rings is wanted.
template <size_t N>
double resampled(const std::array<double, N>& list, int index, int count) {
    const double at = count > 1 ? double(index) * (N - 1) / (count - 1) : 0;
    const size_t i = std::min(size_t(at), N - 2);
    return list[i] + (list[i + 1] - list[i]) * (at - double(i));
}

std::vector<std::pair<double, double>> vaseProfile(int rings) {
    static constexpr std::array<double, 18> kOuter{0,   .02, .05, .09, .14, .20, .27, .34, .41,
                                                   .48, .55, .62, .69, .76, .83, .90, .96, 1};
    static constexpr std::array<double, 11> kInner{1, .93, .85, .77, .69, .60, .51, .42, .32, .22, .13};
    constexpr double kHeight = 0.5, kWall = 0.014, kRimRise = 0.004;
    const int outer = rings * 3 / 5, inner = rings - outer - 1;
    std::vector<std::pair<double, double>> profile;  // radius, y
    for (int i = 0; i < outer; ++i) {
        const double f = resampled(kOuter, i, outer);
        profile.emplace_back(vaseRadius(f), f * kHeight);
    }
    profile.emplace_back(vaseRadius(1) - kWall / 2, kHeight + kRimRise);
    for (int i = 0; i < inner; ++i) {
        const double f = resampled(kInner, i, inner);
        profile.emplace_back(vaseRadius(f) - kWall, f * kHeight);
    }
    return profile;
}

}  // namespace

TriangleMesh makeCube(double side) {
    TriangleMesh mesh;
    mesh.name = "cube";
    const double s = side / 2;
    for (int i = 0; i < 8; ++i) mesh.positions.push_back({i & 1 ? s : -s, i & 2 ? s : -s, i & 4 ? s : -s});
    addQuad(mesh, 0, 4, 6, 2);
    addQuad(mesh, 1, 3, 7, 5);
    addQuad(mesh, 0, 1, 5, 4);
    addQuad(mesh, 2, 6, 7, 3);
    addQuad(mesh, 0, 2, 3, 1);
    addQuad(mesh, 4, 5, 7, 6);
    fillCorners(mesh);
    return mesh;
}

TriangleMesh makeTorus(double R, double r, int n, int m) {
    TriangleMesh mesh;
    mesh.name = "torus";
    for (int i = 0; i < n; ++i) {
        const double u = kTurn * i / n;
        for (int k = 0; k < m; ++k) {
            const double v = kTurn * k / m, ring = R + r * std::cos(v);
            mesh.positions.push_back({ring * std::cos(u), r * std::sin(v), ring * std::sin(u)});
        }
    }
    const auto at = [&](int i, int k) { return uint32_t((i % n) * m + k % m); };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < m; ++k) addQuad(mesh, at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
    fillCorners(mesh);
    return mesh;
}

TriangleMesh makeSphere(double r, int subdivisions) {
    TriangleMesh mesh;
    mesh.name = "sphere";
    const double g = std::numbers::phi;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < subdivisions; ++level) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [it, is_new] = middles.try_emplace(std::minmax(a, b), uint32_t(mesh.positions.size()));
            if (is_new) mesh.positions.push_back(mesh.positions[a] + mesh.positions[b]);
            return it->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(finer);
        for (Double3& p : mesh.positions) p = normalized(p);
    }
    for (Double3& p : mesh.positions) p = normalized(p) * r;
    fillCorners(mesh);
    return mesh;
}

TriangleMesh makeVase(int n, int r) {
    TriangleMesh mesh;
    mesh.name = "vase";
    const auto profile = vaseProfile(r);
    for (const auto& [radius, y] : profile)
        for (int i = 0; i < n; ++i)
            mesh.positions.push_back({radius * std::cos(kTurn * i / n), y, radius * std::sin(kTurn * i / n)});
    const uint32_t outer_pole = uint32_t(mesh.positions.size()), inner_pole = outer_pole + 1;
    mesh.positions.push_back({0, 0, 0});
    mesh.positions.push_back({0, 0.036, 0});
    const auto at = [&](int ring, int i) { return uint32_t(ring * n + i % n); };
    for (int i = 0; i < n; ++i) {
        mesh.triangles.push_back({outer_pole, at(0, i), at(0, i + 1)});
        for (int ring = 0; ring + 1 < r; ++ring)
            addQuad(mesh, at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1));
        mesh.triangles.push_back({inner_pole, at(r - 1, i + 1), at(r - 1, i)});
    }
    fillCorners(mesh);
    return mesh;
}

TriangleMesh makeFork(double neck) {
    const double right = 2 + neck;
    const std::array<Double3, 10> outline{{{0, 0, 0},
                                           {right, 0, 0},
                                           {right, 3, 0},
                                           {3, 3, 0},
                                           {3, 6, 0},
                                           {2, 6, 0},
                                           {2, 1, 0},
                                           {1, 1, 0},
                                           {1, 6, 0},
                                           {0, 6, 0}}};
    constexpr std::array<Triangle, 8> kFront{
        {{0, 1, 6}, {0, 6, 7}, {0, 7, 8}, {0, 8, 9}, {1, 2, 6}, {2, 5, 6}, {2, 3, 5}, {3, 4, 5}}};
    constexpr uint32_t kCount = 10;
    TriangleMesh mesh;
    for (const double z : {0.5, -0.5})
        for (const Double3& p : outline) mesh.positions.push_back({p.x, p.y, z});
    for (const auto& [a, b, c] : kFront) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({kCount + a, kCount + c, kCount + b});
    }
    for (uint32_t k = 0; k < kCount; ++k) {
        const uint32_t next = (k + 1) % kCount;
        addQuad(mesh, k, kCount + k, kCount + next, next);
    }
    fillCorners(mesh);
    return mesh;
}

TriangleMesh turnedInsideOut(TriangleMesh mesh) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    fillCorners(mesh);
    return mesh;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b, const Double3& offset) {
    TriangleMesh mesh = a;
    const uint32_t shift = uint32_t(a.positions.size());
    for (const Double3& p : b.positions) mesh.positions.push_back(p + offset);
    for (const Triangle& t : b.triangles)
        mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    fillCorners(mesh);
    return mesh;
}

double signedVolume(const TriangleMesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        sum += dot(mesh.positions[t[0]], cross(mesh.positions[t[1]], mesh.positions[t[2]]));
    return sum / 6;
}

}  // namespace demolish::test
