// SPDX-License-Identifier: Apache-2.0
// Sums over fragments: momenta kept by the rigid fit, transforms of known motions, ages, any number of
// threads.
#include "sim_cuda/solver/fragment_motion.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <random>

#include "sim_cuda/backend/cpu_backend.h"
#include "tests/unit/neighbours/bonded_grid.h"

namespace demolish {
namespace {
using test::BondedGrid;
constexpr float kPitch = 0.02f;

/// A lattice block with a state of its own, cut as the grid says.
struct Block {
    BondedGrid grid;
    std::vector<Vec4<float>> rest, position, rotation, velocity, spin;
    std::vector<ParticleConstants<float>> constants;

    static ParticleConstants<float> ofMass(float kg) { return {1 / kg, 1e6f, 0.01f, 0.01f}; }
    explicit Block(const BondedGrid& bonds) : grid(bonds) {
        for (uint32_t i = 0; i < grid.count(); ++i) {
            const auto p = grid.placeOf(i);
            rest.push_back({kPitch * float(p.x), kPitch * float(p.y), kPitch * float(p.z), 0});
            rotation.push_back({0, 0, 0, 1});
            constants.push_back(ofMass(0.01f + 0.001f * float(i % 7)));
        }
        position = rest;
        velocity.resize(rest.size());
        spin.resize(rest.size());
    }
    double mass(uint32_t i) const { return 1.0 / double(constants[i].inverseMass()); }
    double inertia(uint32_t i) const { return 1.0 / double(constants[i].inverse_inertia); }
    void shake(unsigned seed) {
        std::mt19937 random(seed);
        std::normal_distribution<float> normal;
        for (uint32_t i = 0; i < grid.count(); ++i) {
            velocity[i] = {3 * normal(random), 3 * normal(random), 3 * normal(random), 0};
            spin[i] = {20 * normal(random), 20 * normal(random), 20 * normal(random), 0};
        }
    }
    /// Turned about the world's origin, then shifted.
    void place(const Quat<float>& q, const Vec3<float>& shift) {
        for (uint32_t i = 0; i < grid.count(); ++i) {
            position[i] = withW(rotate(q, xyz(rest[i])) + shift, 0.0f);
            rotation[i] = asVec4(q);
        }
    }
};

/// The block on the backend, clustered, with its sums gathered.
struct Gathered {
    CpuBackend backend;
    CpuBackend::Buffer<Vec4<float>> position, rotation, velocity, spin;
    CpuBackend::Buffer<ParticleConstants<float>> constants;
    CpuBackend::Buffer<uint32_t> row_start;
    CpuBackend::Buffer<BondLink> link;
    Clustering<CpuBackend> clustering;
    FragmentMotion<CpuBackend, float> motion;
    StateIn<float> state;

    explicit Gathered(const Block& block)
        : position(backend.uploaded(block.position)),
          rotation(backend.uploaded(block.rotation)),
          velocity(backend.uploaded(block.velocity)),
          spin(backend.uploaded(block.spin)),
          constants(backend.uploaded(block.constants)),
          row_start(backend.uploaded(block.grid.row_start)),
          link(backend.uploaded(block.grid.link)),
          clustering(backend, {block.grid.count(), block.grid.count() + kMaxProjectiles}),
          motion(backend, block.rest, {block.grid.count()}, false),
          state{position.view(), rotation.view(), velocity.view(), spin.view()} {
        cluster(block.grid);
    }
    void cluster(const BondedGrid& grid) {
        backend.upload(link.span(), grid.link.data(), grid.link.size());
        clustering.update(row_start.view(), link.view());
        motion.advanceAges(clustering.rows());
        motion.gather(clustering.rows(), state, constants.view());
    }
    std::vector<RigidMotion> fits() {
        return backend.downloaded(motion.fitMotions(clustering.rows(), state, constants.view()));
    }
    std::vector<FragmentTransform> transforms() {
        auto out = backend.allocate<FragmentTransform>(clustering.rows().fragment.size());
        motion.writeTransforms(clustering.rows(), out.span());
        return backend.downloaded(out.span());
    }
};

BondedGrid brokenGrid(double share, unsigned seed) {
    BondedGrid grid(16, 12, 9);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform;
    grid.cut([&](const BondedGrid::Place&, const BondedGrid::Place&) { return uniform(random) < share; });
    return grid;
}

TEST(FragmentMotion, FitKeepsLinearAndAngularMomentumOfEveryFragment) {  // D 23
    Block block(brokenGrid(0.72, 1));
    block.shake(2);
    Gathered gathered(block);
    const auto fits = gathered.fits();
    const auto label = gathered.backend.downloaded(gathered.clustering.rows().fragment);
    struct Sum {
        Vec3<double> p, l;
        double kinetic = 0;
    };
    std::vector<Sum> before(label.size()), after(label.size());
    for (uint32_t i = 0; i < label.size(); ++i) {
        const double m = block.mass(i), inertia = block.inertia(i);
        const auto add = [&](Sum& sum, const Vec3<double>& v, const Vec3<double>& w) {
            sum.p = sum.p + m * v;
            sum.l = sum.l + m * cross(asDouble(xyz(block.position[i])), v) + inertia * w;
            sum.kinetic += 0.5 * m * length2(v) + 0.5 * inertia * length2(w);
        };
        const RigidMotion& fit = fits[label[i]];
        add(before[label[i]], asDouble(xyz(block.velocity[i])), asDouble(xyz(block.spin[i])));
        add(after[label[i]],
            velocityAt(fit.velocity, fit.spin, asDouble(xyz(block.position[i])) - fit.centre), fit.spin);
    }
    size_t fragments = 0;
    for (uint32_t slot = 0; slot < label.size(); ++slot) {
        if (label[slot] != slot) continue;
        ++fragments;
        EXPECT_LT(length(after[slot].p - before[slot].p), 1e-12);  // of order 0.1
        EXPECT_LT(length(after[slot].l - before[slot].l), 1e-13);
        EXPECT_LE(after[slot].kinetic, before[slot].kinetic * (1 + 1e-13));
    }
    EXPECT_GT(fragments, 50u);
    EXPECT_EQ(gathered.motion.summary(gathered.clustering.rows()).fragments, fragments);
}

TEST(FragmentMotion, TransformTakesRestPositionsToPresentOnes) {
    Block block(brokenGrid(0.7, 3));
    const auto q = normalized(Quat<float>{0.3f, -0.5f, 0.1f, 0.7f});
    block.place(q, {4, -2, 1});
    for (uint32_t i = 0; i < block.grid.count(); i += 3) {  // the other cover of the same rotation
        auto& r = block.rotation[i];
        r = {-r.x, -r.y, -r.z, -r.w};
    }
    Gathered gathered(block);
    const auto transforms = gathered.transforms();
    const auto label = gathered.backend.downloaded(gathered.clustering.rows().fragment);
    for (uint32_t i = 0; i < label.size(); ++i) {
        const FragmentTransform& t = transforms[label[i]];
        const Quat<float> turn{t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w};
        const Vec3<float> drawn =
            rotate(turn, xyz(block.rest[i])) + Vec3<float>{t.translation.x, t.translation.y, t.translation.z};
        ASSERT_LT(length(drawn - xyz(block.position[i])), 3e-6f);
    }
}

TEST(FragmentMotion, MeanRotationIsWeightedByMassAndKeepsTheCentre) {
    Block block(BondedGrid(2, 1, 1));
    block.constants = {Block::ofMass(1), Block::ofMass(3)};
    const float angle = 0.2f;
    block.rotation[1] = {0, 0, std::sin(angle / 2), std::cos(angle / 2)};
    block.position[1].y = 0.004f;
    Gathered gathered(block);
    const auto t = gathered.transforms()[0];
    EXPECT_NEAR(2 * std::atan2(t.rotation.z, t.rotation.w), 0.75f * angle, 1e-3f);
    const Quat<float> q{t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w};
    const Vec3<float> centre = rotate(q, Vec3<float>{0.75f * kPitch, 0, 0}) +
                               Vec3<float>{t.translation.x, t.translation.y, t.translation.z};
    EXPECT_NEAR(centre.x, 0.75f * kPitch, 1e-8f);
    EXPECT_NEAR(centre.y, 0.003f, 1e-8f);
}

TEST(FragmentMotion, AgesCountFramesOfFragmentsAndNotOfWholeBodies) {
    BondedGrid grid(10, 2, 2);
    Block block(grid);
    Gathered gathered(block);
    const auto ageAt = [&](uint32_t slot) { return gathered.transforms()[slot].age; };
    gathered.cluster(grid);
    EXPECT_EQ(ageAt(0), 0u);
    grid.cut([](const BondedGrid::Place& a, const BondedGrid::Place& b) { return (a.x < 4) != (b.x < 4); });
    for (uint32_t frame = 1; frame <= 3; ++frame) {
        gathered.cluster(grid);
        EXPECT_EQ(ageAt(0), frame);
        EXPECT_EQ(ageAt(4), frame);
    }
    grid.cut([](const BondedGrid::Place& a, const BondedGrid::Place& b) { return (a.x < 8) != (b.x < 8); });
    const auto saved = gathered.motion.saveState();
    for (int repeat = 0; repeat < 2; ++repeat) {
        gathered.cluster(grid);
        EXPECT_EQ(ageAt(0), 4u);  // the same piece as before
        EXPECT_EQ(ageAt(4), 1u);  // lost its end
        EXPECT_EQ(ageAt(8), 1u);
        gathered.motion.restoreState(saved);
    }
}

TEST(FragmentMotion, SummaryFindsTheLargestMass) {
    BondedGrid grid(10, 2, 2);
    grid.cut([](const BondedGrid::Place& a, const BondedGrid::Place& b) { return (a.x < 4) != (b.x < 4); });
    Block block(grid);
    double mass = 0;
    for (uint32_t i = 0; i < grid.count(); ++i)
        if (grid.placeOf(i).x >= 4) mass += block.mass(i);
    Gathered gathered(block);
    const auto summary = gathered.motion.summary(gathered.clustering.rows());
    EXPECT_EQ(summary.fragments, 2u);
    EXPECT_NEAR(summary.largest_mass, mass, 1e-12);
}

TEST(FragmentMotion, HasTheSameBitsForOneThreadAndTwo) {
    Block block(brokenGrid(0.6, 5));
    block.shake(6);
    std::vector<std::vector<RigidMotion>> results;
    for (const size_t threads : {1u, 2u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Gathered gathered(block);
        results.push_back(gathered.fits());
    }
    for (size_t i = 0; i < results[0].size(); ++i) {
        ASSERT_EQ(results[0][i].spin.x, results[1][i].spin.x);
        ASSERT_EQ(results[0][i].centre.y, results[1][i].centre.y);
        ASSERT_EQ(results[0][i].velocity.z, results[1][i].velocity.z);
    }
}

}  // namespace
}  // namespace demolish
