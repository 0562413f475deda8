// SPDX-License-Identifier: Apache-2.0
// What a decision finds must not depend on how many threads share a particle's rows: the GPU has eight, the
// CPU one.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "sim_cuda/kernels/islands.h"
#include "tests/unit/neighbours/particle_cloud.h"

namespace demolish {
namespace {

/// A few fragments of one particle each that fly about, some moved with bonds: small enough that what one of
/// them sees is not seen by another anyway.
class Crowd {
  public:
    explicit Crowd(unsigned seed)
        : cloud_(test::randomCloud(9, 0.08, 0.006, 0.014, 6, seed)),
          arrays_(cloud_),
          lists_(arrays_.backend, cloud_.counts(), cloud_.largestRadius()) {
        lists_.build(arrays_.state(), arrays_.particles.constants.view(), arrays_.bonds.in());
        const auto total = static_cast<uint32_t>(cloud_.items.size());
        for (uint32_t i = 0; i < total; ++i) label_.push_back(i);
        std::vector<uint32_t> order(cloud_.in_bodies), size(cloud_.in_bodies), first(cloud_.in_bodies);
        std::iota(order.begin(), order.end(), 0u);
        std::vector<uint32_t> regime(total, wordOf(Regime::kRigid));
        for (uint32_t i = 0; i < cloud_.in_bodies; ++i) {
            size[i] = i % 4 == 0 ? 5 : 40;
            first[i] = i;
            if ((i + seed) % 3 == 0) regime[i] = wordOf(Regime::kBonded);
        }
        regime_ = arrays_.backend.uploaded(regime);
        order_ = arrays_.backend.uploaded(order);
        size_ = arrays_.backend.uploaded(size);
        first_ = arrays_.backend.uploaded(first);
        labels_ = arrays_.backend.uploaded(label_);
        zeros_ = arrays_.backend.allocate<uint32_t>(total);
        clock_ = arrays_.backend.allocate<CalmClock>(total);
        wake_ = arrays_.backend.uploaded(std::vector<WakeLaw<float>>(1, {4.0f, 0.0f, 1.0f}));
    }
    /// `all_ask`: also those of whom JoinIslands has found no meeting.
    template <uint32_t kThreads>
    std::vector<uint32_t> flagged(bool all_ask = false) {
        const auto total = static_cast<uint32_t>(cloud_.items.size());
        auto flags = arrays_.backend.allocate<uint32_t>(total),
             words = arrays_.backend.allocate<uint32_t>(kWorkWords),
             island = arrays_.backend.uploaded(label_), meets = arrays_.backend.allocate<uint32_t>(total);
        const MeetingsIn<float> meetings{arrays_.state(),
                                         lists_.contacts().paths(),
                                         arrays_.particles.constants.view(),
                                         labels_.view(),
                                         zeros_.view(),
                                         arrays_.bonds.in(),
                                         lists_.contacts().in(),
                                         cloud_.in_bodies,
                                         float(lists_.horizon()),
                                         4e-3f,
                                         2e-3f};
        const auto floor = makeColliderSet<float>({Plane{{0, 1, 0}, -0.16}});
        const FragmentRows rows{order_.view(), labels_.view().part(0, cloud_.in_bodies), first_.view(),
                                size_.view()};
        RegimeRules rules;
        rules.hand_over = rules.may_calm = true;
        rules.calm_substeps = rules.rest_substeps = 10;
        const HitRules<float> hits{meetings, rows, regime_.view(), wake_.view(), 8};
        const HitsOnColliders<float> landing{floor, {0, -9.81f, 0}};
        if (all_ask)
            arrays_.backend.fill(meets.span(), 1u);
        else
            arrays_.backend.forEach(
                size_t{total} * kThreads,
                JoinIslands<kThreads, float>{hits, landing, island.span(), meets.span(), words.span()},
                "join");
        without_meetings += static_cast<uint32_t>(std::count(&meets.view()[0], &meets.view()[0] + total, 0u));
        arrays_.backend.fill(words.span(), 0u);
        arrays_.backend.forEach(
            size_t{total} * kThreads,
            FlagIslands<kThreads, float>{hits, labels_.view(), meets.view(), clock_.view(), landing, rules,
                                         flags.span(), words.span()},
            "flag");
        std::vector<uint32_t> found(&flags.view()[0], &flags.view()[0] + total);
        found.push_back(words.view()[kHitsLater]);
        return found;
    }

    uint32_t without_meetings = 0;  ///< particles, over all calls

  private:
    test::Cloud cloud_;
    test::CloudArrays arrays_;
    NeighbourLists<CpuBackend, float> lists_;
    std::vector<uint32_t> label_;
    CpuBackend::Buffer<uint32_t> order_, size_, first_, labels_, zeros_, regime_;
    CpuBackend::Buffer<CalmClock> clock_;
    CpuBackend::Buffer<WakeLaw<float>> wake_;
};

TEST(FlagIslands, AnyNumberOfThreadsAParticleFindsTheSame) {
    uint32_t at_once = 0, later = 0, neither = 0, without_meetings = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        Crowd crowd(seed);
        const std::vector<uint32_t> by_one = crowd.flagged<1>();
        EXPECT_EQ(by_one, crowd.flagged<8>()) << "seed " << seed;
        EXPECT_EQ(by_one, crowd.flagged<ThreadsOfFew::kFirst>()) << "seed " << seed;
        without_meetings += crowd.without_meetings;
        EXPECT_EQ(by_one, crowd.flagged<1>(true)) << "seed " << seed;
        later += by_one.back();
        for (size_t i = 0; i < 9; ++i) ((by_one[i] & kNeedsBonds) != 0 ? at_once : neither) += 1;
    }
    EXPECT_GT(at_once, 20u);
    EXPECT_GT(neither, 20u);
    EXPECT_GT(without_meetings, 100u);
    EXPECT_GT(later, 10u);
    EXPECT_LT(later, 190u);
}

}  // namespace
}  // namespace demolish
