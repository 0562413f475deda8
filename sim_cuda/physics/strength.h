// SPDX-License-Identifier: Apache-2.0
// Set-up: how the strength of single bonds scatters. Weibull factor of physics A.4.
#pragma once
#include <cmath>

#include "sim_cuda/physics/random.h"

namespace demolish {

/// s = (-ln U)^(1/k)/Gamma(1+1/k), mean 1, U = hash of (object seed, bond id). Modulus k > 0: 3 (wide) .. 15
/// (narrow); k = 0 turns the scatter off (1).
inline double weibullFactor(double modulus, uint64_t object_seed, uint64_t bond) {
    if (!(modulus > 0)) return 1;
    const double u = uniformOf(object_seed, bond);
    return std::pow(-std::log(u), 1 / modulus) / std::tgamma(1 + 1 / modulus);
}

}  // namespace demolish
