// SPDX-License-Identifier: Apache-2.0
// What a look at the state says of one particle: fine, not finite in any of its numbers, out of the scene.
#include <gtest/gtest.h>

#include <limits>

#include "sim_cuda/kernels/look_at_state.h"

namespace demolish::tests {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// One particle that is on its path, in a scene of 10 m.
struct LookedAt {
    Vec4<float> position{1, 2, 3, 0}, rotation{0, 0, 0, 1}, velocity{4, 5, 6, 0}, spin{7, 8, 9, 0};

    uint32_t status() const {
        const Vec4<float> path_position = withW(xyz(position), 0.1f),
                          path_velocity = withW(xyz(velocity), 0.1f);
        const ParticleConstants<float> constants{1, 1, 0.1f, 0.1f};
        uint32_t words[kLookWords] = {};
        const CheckPaths<float> paths{{{{&position, 1}, {&rotation, 1}, {&velocity, 1}, {&spin, 1}},
                                       {{&path_position, 1}, {&path_velocity, 1}}},
                                      {&words[kLookRebuild], 1}};
        LookAtState<float>{paths, {&constants, 1}, {words, kLookWords}, 10}(0);
        return words[kLookStatus];
    }
};

TEST(Look, FindsNothingWrongWithAParticleThatMovesInTheScene) {
    EXPECT_EQ(LookedAt{}.status(), 0u);
}

TEST(Look, SeesANumberThatIsNotFiniteInPositionRotationVelocityAndSpin) {
    for (const float bad : {kNaN, kInfinity}) {
        for (Vec4<float> LookedAt::*part :
             {&LookedAt::position, &LookedAt::rotation, &LookedAt::velocity, &LookedAt::spin}) {
            LookedAt looked_at;
            (looked_at.*part).y = bad;
            EXPECT_EQ(looked_at.status(), kSawNotFinite);
        }
        LookedAt looked_at;
        looked_at.rotation.w = bad;
        EXPECT_EQ(looked_at.status(), kSawNotFinite);
    }
}

TEST(Look, SeesWhoHasLeftTheScene) {
    LookedAt looked_at;
    looked_at.position.x = 11;
    EXPECT_EQ(looked_at.status(), kSawLeftScene);
}

}  // namespace
}  // namespace demolish::tests
