// SPDX-License-Identifier: Apache-2.0
// Random numbers of one grain or puff: a sequence that hangs on its birth number alone.
#pragma once
#include "sim_cuda/physics/quaternion.h"
#include "sim_cuda/physics/random.h"

namespace demolish {

class Draws {
  public:
    DEM_FN Draws(uint64_t seed, uint64_t number) : state_(counterHash(seed, number)) {}

    DEM_FN uint32_t word() {
        state_ += 0x9e3779b97f4a7c15ull;
        uint64_t z = (state_ ^ (state_ >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return static_cast<uint32_t>(z >> 32);
    }
    /// Uniform, 0 <= u < 1.
    DEM_FN float uniform() { return static_cast<float>(word() >> 8) * (1.0f / 16777216.0f); }
    /// Uniform, -1 <= u < 1.
    DEM_FN float symmetric() { return 2.0f * uniform() - 1.0f; }
    /// A whole number with this mean, one of the two next to it.
    DEM_FN uint32_t whole(float mean) { return static_cast<uint32_t>(mean + uniform()); }
    /// In the unit ball. Half of a cube's points lie in its ball: after four tries hardly any is left over,
    /// and those are drawn in.
    DEM_FN Vec3<float> inBall() {
        Vec3<float> p{};
        for (int tries = 0; tries < 4; ++tries) {
            p = {symmetric(), symmetric(), symmetric()};
            if (length2(p) <= 1.0f) return p;
        }
        return 0.5f * p;
    }
    DEM_FN Vec3<float> direction() { return normalized(inBall()); }
    DEM_FN Quat<float> orientation() {
        return normalized(Quat<float>{symmetric(), symmetric(), symmetric(), symmetric() + 1e-3f});
    }

  private:
    uint64_t state_;
};

}  // namespace demolish
