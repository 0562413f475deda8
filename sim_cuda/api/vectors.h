// SPDX-License-Identifier: Apache-2.0
// Plain vectors of the public interface: data only, no arithmetic (that lives in physics/vector.h).
#pragma once
#include <array>
#include <cstdint>

namespace demolish {

struct Float2 {
    float x = 0, y = 0;
    bool operator==(const Float2&) const = default;
};
struct Float3 {
    float x = 0, y = 0, z = 0;
    bool operator==(const Float3&) const = default;
};
struct Float4 {
    float x = 0, y = 0, z = 0, w = 0;
    bool operator==(const Float4&) const = default;
};
struct Double3 {
    double x = 0, y = 0, z = 0;
    bool operator==(const Double3&) const = default;
};
/// Unit quaternion, rotates by q v q*.
struct Quaternion {
    double x = 0, y = 0, z = 0, w = 1;
    bool operator==(const Quaternion&) const = default;
};
/// Symmetric 3x3 tensor.
struct SymmetricTensor {
    double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
    bool operator==(const SymmetricTensor&) const = default;
};

}  // namespace demolish
