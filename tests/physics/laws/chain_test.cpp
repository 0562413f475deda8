// SPDX-License-Identifier: Apache-2.0
// Chains of bonds against beam and wave theory: physics D 11, 12, 13. Statics by the stiffness matrix of the
// laws themselves.
#include <gtest/gtest.h>

#include "sim_cuda/physics/bond_stiffness.h"
#include "tests/physics/laws/bonded_set.h"

namespace demolish {
namespace {

using Matrix = std::vector<std::vector<double>>;
constexpr double kPitch = 0.05;

BondStiffness<double> stiffness() {
    return beamBond(4e6, 1.1e-3, kPitch);
}

/// Moves one degree of freedom of one particle: 0..2 shift (m), 3..5 rotation (rad).
void displace(test::ParticleState<double>& s, size_t axis, double amount) {
    double v[3] = {};
    v[axis % 3] = amount;
    const Vec3<double> vector{v[0], v[1], v[2]};
    if (axis < 3)
        s.position = s.position + vector;
    else
        s.rotation = laws::exponential(0.5 * vector);
}

std::vector<double> residual(test::BondedSet<double> set, size_t particle, size_t axis, double amount) {
    displace(set.particles[particle], axis, amount);
    set.evaluate();
    std::vector<double> forces;
    for (size_t p = 1; p < set.particles.size(); ++p) {
        const auto& w = set.loads[p];
        for (const double f : {w.force.x, w.force.y, w.force.z, w.torque.x, w.torque.y, w.torque.z})
            forces.push_back(f);
    }
    return forces;
}

/// Stiffness matrix about rest with particle 0 clamped: central differences of the law's forces.
Matrix stiffnessMatrix(const test::BondedSet<double>& set) {
    const size_t n = 6 * (set.particles.size() - 1);
    Matrix k(n, std::vector<double>(n));
    for (size_t column = 0; column < n; ++column) {
        const double h = column % 6 < 3 ? 1e-5 * kPitch : 1e-5;
        const auto plus = residual(set, 1 + column / 6, column % 6, h),
                   minus = residual(set, 1 + column / 6, column % 6, -h);
        for (size_t row = 0; row < n; ++row) k[row][column] = -(plus[row] - minus[row]) / (2 * h);
    }
    return k;
}

std::vector<double> solve(Matrix a, std::vector<double> b) {
    const size_t n = b.size();
    for (size_t pivot = 0; pivot < n; ++pivot) {
        for (size_t row = pivot + 1; row < n; ++row) {
            const double f = a[row][pivot] / a[pivot][pivot];
            if (f == 0) continue;
            for (size_t column = pivot; column < n; ++column) a[row][column] -= f * a[pivot][column];
            b[row] -= f * b[pivot];
        }
    }
    for (size_t row = n; row-- > 0;) {
        for (size_t column = row + 1; column < n; ++column) b[row] -= a[row][column] * b[column];
        b[row] /= a[row][row];
    }
    return b;
}

/// Displacements of the last particle under a load on it.
std::vector<double> tipUnder(size_t bonds, size_t axis, double load) {
    const auto set = test::chain(bonds, kPitch, stiffness());
    std::vector<double> forces(6 * bonds);
    forces[6 * (bonds - 1) + axis] = load;
    const auto all = solve(stiffnessMatrix(set), forces);
    return {all.end() - 6, all.end()};
}

TEST(Chain, CantileverTipMatchesTheSumOverItsBonds) {  // D 11
    const auto k = stiffness();
    const double F = 1e-3;
    for (const size_t n : {5u, 10u, 20u}) {
        double sum = 0;
        for (size_t bond = 0; bond < n; ++bond) {
            const double arm = (double(n) - double(bond) - 0.5) * kPitch;
            sum += 1 / k.shear + arm * arm / k.bending;
        }
        const double length = double(n) * kPitch;
        const double closed = length * length * length / (3 * k.bending * kPitch) +
                              double(n) * (1 / k.shear - kPitch * kPitch / (12 * k.bending));
        EXPECT_NEAR(closed / sum, 1, 1e-12);
        const auto tip = tipUnder(n, 1, F);
        EXPECT_NEAR(tip[1] / (F * sum), 1, 1e-6) << n;
    }
}

TEST(Chain, TensionAndTwistAddUpOverTheBonds) {  // D 12
    const auto k = stiffness();
    EXPECT_NEAR(tipUnder(10, 0, 2e-3)[0] / (2e-3 * 10 / k.normal), 1, 1e-6);
    EXPECT_NEAR(tipUnder(10, 3, 2e-3)[3] / (2e-3 * 10 / k.torsion), 1, 1e-4);
}

TEST(Chain, StiffnessMatrixIsSymmetric) {  // the forces have a potential, to first order
    const auto k = stiffnessMatrix(test::chain(3, kPitch, stiffness()));
    for (size_t row = 0; row < k.size(); ++row)
        for (size_t column = 0; column < row; ++column)
            EXPECT_NEAR(k[row][column], k[column][row], 1e-7 * stiffness().normal * (1 + kPitch));
}

/// Angular frequency of longitudinal mode p of a free chain: the mode's amplitude is followed over some
/// periods.
double longitudinalFrequency(size_t count, size_t mode) {
    auto set = test::chain(count - 1, kPitch, stiffness());
    set.mass = 0.3;
    set.inertia = 1e-4;
    const double omega0 = 2 * std::sqrt(stiffness().normal / set.mass), dt = 0.02 / omega0;
    std::vector<double> shape;
    for (size_t p = 0; p < count; ++p)
        shape.push_back(std::cos(kPi * double(mode) * (double(p) + 0.5) / double(count)));
    for (size_t p = 0; p < count; ++p) set.particles[p].position.x += 1e-4 * kPitch * shape[p];
    double previous = 1, first = 0, last = 0;
    int crossings = 0;
    for (int step = 1; crossings < 3; ++step) {
        set.step(dt);
        double amplitude = 0;
        for (size_t p = 0; p < count; ++p)
            amplitude += shape[p] * (set.particles[p].position.x - double(p) * kPitch);
        if ((amplitude > 0) != (previous > 0)) {
            last = (step - amplitude / (amplitude - previous)) * dt;
            if (++crossings == 1) first = last;
        }
        previous = amplitude;
    }
    return 2 * kPi / (last - first);
}

TEST(Chain, FirstModeTravelsAtTheWaveSpeed) {  // D 13
    const size_t count = 200;
    const double speed = longitudinalFrequency(count, 1) / kPi * double(count) * kPitch;
    EXPECT_NEAR(speed / (kPitch * std::sqrt(stiffness().normal / 0.3)), 1, 1e-3);
}

TEST(Chain, DispersionIsThatOfALattice) {  // D 13
    const size_t count = 40;
    for (const size_t mode : {4u, 20u, 36u}) {
        const double wave_number = kPi * double(mode) / (double(count) * kPitch);
        const double expected = 2 * std::sqrt(stiffness().normal / 0.3) * std::sin(wave_number * kPitch / 2);
        EXPECT_NEAR(longitudinalFrequency(count, mode) / expected, 1, 1e-3) << mode;
    }
}

}  // namespace
}  // namespace demolish
