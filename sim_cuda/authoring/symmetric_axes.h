// SPDX-License-Identifier: Apache-2.0
// Eigenvalues and axes of a symmetric 3x3 tensor.
#pragma once
#include <array>

#include "sim_cuda/api/vectors.h"

namespace demolish {

struct SymmetricAxes {
    std::array<double, 3> value;  ///< descending
    std::array<Double3, 3> axis;  ///< unit, in the same order
};

/// By Jacobi rotations.
SymmetricAxes symmetricAxes(const SymmetricTensor& tensor);

}  // namespace demolish
