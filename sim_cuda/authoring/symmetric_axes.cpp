// SPDX-License-Identifier: Apache-2.0
// Jacobi rotations until nothing is left off the diagonal; a 3x3 tensor takes a handful of sweeps.
#include "sim_cuda/authoring/symmetric_axes.h"

#include <algorithm>
#include <cmath>

namespace demolish {
namespace {

constexpr int kMostSweeps = 12;
using Matrix = std::array<std::array<double, 3>, 3>;

/// Turns the plane of axes i and j so that a[i][j] vanishes; the columns of `q` turn along.
void rotate(Matrix& a, Matrix& q, size_t i, size_t j) {
    if (a[i][j] == 0) return;
    const double half = (a[j][j] - a[i][i]) / (2 * a[i][j]);
    const double tangent = std::copysign(1.0, half) / (std::fabs(half) + std::sqrt(half * half + 1));
    const double c = 1 / std::sqrt(tangent * tangent + 1), s = tangent * c;
    for (size_t k = 0; k < 3; ++k) {
        const double x = a[k][i], y = a[k][j];
        a[k][i] = c * x - s * y;
        a[k][j] = s * x + c * y;
    }
    for (size_t k = 0; k < 3; ++k) {
        const double x = a[i][k], y = a[j][k];
        a[i][k] = c * x - s * y;
        a[j][k] = s * x + c * y;
        const double u = q[k][i], v = q[k][j];
        q[k][i] = c * u - s * v;
        q[k][j] = s * u + c * v;
    }
}

}  // namespace

SymmetricAxes symmetricAxes(const SymmetricTensor& t) {
    Matrix a{{{t.xx, t.xy, t.zx}, {t.xy, t.yy, t.yz}, {t.zx, t.yz, t.zz}}};
    Matrix q{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        rotate(a, q, 0, 1);
        rotate(a, q, 0, 2);
        rotate(a, q, 1, 2);
    }
    std::array<size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return a[i][i] > a[j][j]; });
    SymmetricAxes axes{};
    for (size_t k = 0; k < 3; ++k) {
        axes.value[k] = a[order[k]][order[k]];
        axes.axis[k] = {q[0][order[k]], q[1][order[k]], q[2][order[k]]};
    }
    return axes;
}

}  // namespace demolish
