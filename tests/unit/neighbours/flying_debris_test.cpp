// SPDX-License-Identifier: Apache-2.0
// The rule of predicted_path.h at work: fast debris that collides, curves and is kicked about never touches
// unlisted.
#include <gtest/gtest.h>

#include "sim_cuda/kernels/strayed_paths.h"
#include "tests/unit/neighbours/particle_cloud.h"

namespace demolish {
namespace {
using test::Cloud;
using test::CloudArrays;

struct Flight {
    Cloud cloud;
    CloudArrays arrays;
    NeighbourLists<CpuBackend, float> lists;
    float dt = 5e-5f, since_build = 0;
    int interval = 5;  ///< steps between two looks
    size_t touching = 0, missed = 0, looks = 0;
    bool follows = false;  ///< who strays gets a new path where that is enough
    size_t followed = 0, inserted = 0;

    explicit Flight(Cloud start)
        : cloud(std::move(start)),
          arrays(cloud),
          lists(arrays.backend, cloud.counts(), cloud.largestRadius()) {}

    void refresh() {
        arrays.move(cloud);
        lists.build(arrays.state(), arrays.particles.constants.view(), arrays.bonds.in());
        since_build = 0;
    }
    template <uint32_t kThreads>
    void see(const PathsNow<float>& paths, Span<const uint32_t> labels, Span<const uint32_t> strayed,
             Span<uint64_t> lacking, Span<uint32_t> words) {
        arrays.backend.forEach(cloud.items.size() * kThreads,
                               SeeStrayed<kThreads, float>{paths,
                                                           arrays.bonds.in(),
                                                           lists.contacts().in(),
                                                           labels,
                                                           {},
                                                           arrays.particles.constants.view(),
                                                           {},
                                                           9.81f,
                                                           float(lists.horizon()) - since_build,
                                                           1e9f,
                                                           cloud.in_bodies,
                                                           strayed,
                                                           lacking,
                                                           words},
                               "see");
    }
    /// Entries may come in any order.
    static std::vector<uint64_t> sorted(Span<const uint64_t> lacking, Span<const uint32_t> words) {
        const size_t count = std::min<size_t>(words[kEntriesLacking], lacking.count);
        std::vector<uint64_t> entries(&lacking[0], &lacking[0] + count);
        std::sort(entries.begin(), entries.end());
        return entries;
    }
    /// False: the lists must be made again.
    bool follow(float lookahead) {
        auto strayed = arrays.backend.allocate<uint32_t>(kMostStrayed);
        auto lacking = arrays.backend.allocate<uint64_t>(kMostInserted);
        auto words = arrays.backend.allocate<uint32_t>(kStrayWords);
        std::vector<uint32_t> label(cloud.items.size());
        for (uint32_t i = 0; i < label.size(); ++i) label[i] = i;
        auto labels = arrays.backend.uploaded(label);
        auto& contacts = lists.contacts();
        const PathsNow<float> paths{arrays.state(), contacts.paths(), since_build, lookahead};
        const size_t total = cloud.items.size();
        arrays.backend.forEach(total, ListStrayed<float>{paths, strayed.span(), words.span()}, "list");
        auto others_lacking = arrays.backend.allocate<uint64_t>(kMostInserted);
        auto others_words = arrays.backend.uploaded(arrays.backend.downloaded(words.view()));
        see<8>(paths, labels.view(), strayed.view(), others_lacking.span(), others_words.span());
        see<1>(paths, labels.view(), strayed.view(), lacking.span(), words.span());
        EXPECT_EQ(arrays.backend.downloaded(words.view()), arrays.backend.downloaded(others_words.view()));
        EXPECT_EQ(sorted(lacking.view(), words.view()), sorted(others_lacking.view(), words.view()))
            << "threads that share a particle see the same";
        arrays.backend.forEach(
            kMostStrayed,
            RestartStrayed<float>{paths, strayed.view(), words.view(), contacts.built_position.span(),
                                  contacts.built_velocity.span()},
            "restart");
        const uint32_t count = words.span()[kEntriesLacking];
        if (words.span()[kStrayedCount] > kMostStrayed || count > kMostInserted) return false;
        if (count > 0) lists.insert(lacking.view().part(0, count));
        inserted += count;
        ++followed;
        return true;
    }
    void look() {
        ++looks;
        arrays.move(cloud);
        const float lookahead = dt * float(interval);
        auto flag = arrays.backend.allocate<uint32_t>(1);
        arrays.backend.forEach(
            cloud.items.size(),
            CheckPaths<float>{{arrays.state(), lists.contacts().paths(), since_build, lookahead},
                              flag.span()},
            "check paths");
        if (flag.span()[0] != 0 && follows && since_build + lookahead <= lists.horizon() && follow(lookahead))
            flag.span()[0] = 0;
        if (flag.span()[0] != 0 || since_build + lookahead > lists.horizon()) refresh();
    }
    bool listed(uint32_t i, uint32_t j) const {
        const auto in = lists.contacts().in();
        return std::binary_search(&in.neighbour[in.row_start[i]], &in.neighbour[0] + in.row_start[i + 1], j);
    }
    /// Every touching pair must be listed at both ends; then a stiff spring pushes the two apart.
    void collide() {
        const auto n = static_cast<uint32_t>(cloud.items.size());
        for (uint32_t i = 0; i < n; ++i)
            for (uint32_t j = i + 1; j < n; ++j) {
                auto &a = cloud.items[i], &b = cloud.items[j];
                if (!a.active || !b.active) continue;
                const Vec3<float> gap = b.x - a.x;
                const float reach = a.radius + b.radius, distance2 = length2(gap);
                if (distance2 >= reach * reach) continue;
                ++touching;
                missed += !listed(i, j) || !listed(j, i);
                const float overlap = reach - std::sqrt(distance2);
                const Vec3<float> push = (dt * 2e6f * overlap) * normalized(gap);
                b.v = b.v + push;
                a.v = a.v - push;
            }
    }
    void fly(int steps, bool curved) {
        refresh();
        for (int step = 0; step < steps; ++step) {
            if (step % interval == 0) look();
            collide();
            for (auto& item : cloud.items) {
                if (!item.active) continue;
                if (curved) item.v = item.v + dt * cross(Vec3<float>{0, 0, 40}, item.v);  // turns 40 rad/s
                item.v = item.v + dt * Vec3<float>{0, -9.81f, 0};
                item.x = axpy(dt, item.v, item.x);
            }
            since_build += dt;
        }
    }
};

TEST(FlyingDebris, NeverTouchesUnlisted) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        Flight flight(test::randomCloud(350, 0.35, 0.006, 0.014, 10, seed));
        auto& ball = flight.cloud.items[flight.cloud.in_bodies + 1];
        ball = {{-0.4f, 0, 0}, {20, 0, 0}, 0.06f, true};
        flight.arrays.particles.constants.span()[flight.cloud.in_bodies + 1] = {0.1f, 1, 0.06f, 0.06f};
        flight.fly(800, seed == 3);
        EXPECT_GT(flight.touching, 3000u);
        EXPECT_EQ(flight.missed, 0u) << "seed " << seed;
        EXPECT_LT(flight.lists.builds(), flight.looks) << "the horizon was worth nothing";
    }
}

TEST(FlyingDebris, ThoseWhoStrayAreFollowedAndTouchNothingUnlisted) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        Flight made_again(test::randomCloud(350, 0.35, 0.006, 0.014, 10, seed)), followed(made_again.cloud);
        followed.follows = true;
        for (Flight* flight : {&made_again, &followed}) flight->fly(800, seed == 3);
        EXPECT_GT(followed.touching, 3000u);
        EXPECT_EQ(followed.missed, 0u) << "seed " << seed;
        EXPECT_GT(followed.followed, 0u) << "seed " << seed;
        EXPECT_GT(followed.inserted, 0u) << "seed " << seed;
        EXPECT_LT(followed.lists.builds(), made_again.lists.builds()) << "seed " << seed;
    }
}

TEST(FlyingDebris, ACrumbThatTurnsRoundInTheOpenCostsNoBuild) {
    Cloud cloud;
    cloud.items = {{{0, 0, 0}, {5, 0, 0}, 0.01f, true}, {{0, 0.3f, 0}, {}, 0.01f, true}};
    cloud.addProjectileSlots();
    Flight flight(cloud);
    flight.follows = true;
    flight.refresh();
    flight.since_build = 1e-3f;
    flight.cloud.items[0].x.x = 5e-3f;
    flight.cloud.items[0].v.x = -5;
    flight.look();
    EXPECT_EQ(flight.followed, 1u);
    EXPECT_EQ(flight.lists.builds(), 1u);
    // On its new path it strays no more.
    flight.since_build = 2e-3f;
    flight.cloud.items[0].x.x = 0;
    flight.look();
    EXPECT_EQ(flight.followed, 1u);
    EXPECT_EQ(flight.lists.builds(), 1u);
}

TEST(FlyingDebris, ACrumbThatMayReachAStrangerIsListedWithIt) {
    Cloud cloud;
    cloud.items = {{{0, 0, 0}, {-5, 0, 0}, 0.01f, true}, {{0.045f, 0, 0}, {}, 0.01f, true}};
    cloud.addProjectileSlots();
    Flight flight(cloud);
    flight.follows = true;
    flight.refresh();
    EXPECT_FALSE(flight.listed(0, 1));
    flight.since_build = 1e-3f;
    flight.cloud.items[0].x.x = -5e-3f;
    flight.cloud.items[0].v.x = 5;
    flight.look();
    EXPECT_EQ(flight.followed, 1u);
    EXPECT_EQ(flight.lists.builds(), 1u);
    // Reaches with skins: 0.05 m less 2 (0.01 + 0.005), at 5 m/s.
    EXPECT_GT(flight.lists.horizon(), 1e-3 + 0.02 / 5);
    EXPECT_TRUE(flight.listed(0, 1));
    EXPECT_TRUE(flight.listed(1, 0));
}

TEST(FlyingDebris, FragmentsThatFlyTogetherDoNotRebuild) {
    // Two blocks, each moving as one, apart from each other at 20 m/s: only the horizon ends a list's life.
    Cloud cloud;
    for (int block = 0; block < 2; ++block)
        for (int k = 0; k < 125; ++k)
            cloud.items.push_back({{float(k % 5) * 0.021f + float(block) * 0.2f, float(k / 5 % 5) * 0.021f,
                                    float(k / 25) * 0.021f},
                                   {block == 0 ? -10.0f : 10.0f, 0, 0},
                                   0.01f,
                                   true});
    cloud.addProjectileSlots();
    Flight flight(cloud);
    const int steps = 600;
    flight.fly(steps, false);
    EXPECT_EQ(flight.touching, 0u);
    const double lives = steps * double(flight.dt) / flight.lists.horizon();
    EXPECT_LE(double(flight.lists.builds()), 1.3 * lives + 2);
    const auto in = flight.lists.contacts().in();
    for (uint32_t i = 0; i < 125; ++i)
        for (uint32_t k = in.row_start[i]; k < in.row_start[i + 1]; ++k) EXPECT_LT(in.neighbour[k], 125u);
}

TEST(FlyingDebris, ABodyAtRestKeepsItsListsForTheWholeHorizon) {
    Flight flight(test::randomCloud(200, 5.0, 0.006, 0.014, 0, 4));
    flight.refresh();
    EXPECT_EQ(flight.lists.horizon(), 1.0);
    flight.look();
    EXPECT_EQ(flight.lists.builds(), 1u);
}

TEST(FlyingDebris, AStateThatIsNotFiniteRaisesTheFlagAndBreaksNothing) {
    Flight flight(test::randomCloud(50, 0.2, 0.006, 0.014, 1, 5));
    flight.refresh();
    flight.cloud.items[7].x.y = std::nanf("");
    flight.look();
    EXPECT_EQ(flight.lists.builds(), 2u);
}

}  // namespace
}  // namespace demolish
