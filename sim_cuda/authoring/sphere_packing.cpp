// SPDX-License-Identifier: Apache-2.0
// FIRE (Bitzek et al. 2006, Phys. Rev. Lett. 97, 170201) on E = sum over overlaps of overlap^2 / 2, in units
// of the mean radius, with neighbour lists that are renewed as spheres move.
#include "sim_cuda/authoring/sphere_packing.h"

#include <algorithm>
#include <numeric>

#include "sim_cuda/authoring/hash_random.h"
#include "sim_cuda/authoring/seed_grid.h"

namespace demolish {
namespace {

constexpr uint64_t kPlaceStream = 71;
constexpr int kMostSteps = 4000;
constexpr double kGoodOverlap = 1e-4;  // of the mean radius: of the deepest pair
constexpr double kSkin = 0.4;          // of the mean radius

class Relaxation {
  public:
    Relaxation(std::vector<double> radii, double container, uint64_t seed)
        : radii_(std::move(radii)), container_(container), velocity_(radii_.size()), force_(radii_.size()) {
        largest_ = *std::max_element(radii_.begin(), radii_.end());
        for (uint64_t tried = 0; places_.size() < radii_.size(); ++tried) {
            const Double3 p = 2 * hashRandomInCube(seed, kPlaceStream, tried);
            if (lengthSquared(p) <= 1) places_.push_back((container_ - radii_[places_.size()]) * p);
        }
    }

    std::vector<Double3> run() {
        for (int step = 0; step < kMostSteps; ++step)
            if (computeForces() < kGoodOverlap)
                break;
            else
                move();
        return places_;
    }

  private:
    /// Lists every pair that may touch before one of them has moved by half the skin.
    void listPairs() {
        pairs_.clear();
        listed_ = places_;
        const double edge = 2 * largest_ + kSkin;
        const SeedGrid grid(places_, edge);
        for (uint32_t i = 0; i < places_.size(); ++i)
            for (int ring = 0; ring <= 1; ++ring)
                grid.visitRing(grid.placeOf(places_[i]), ring, [&](uint32_t j, const Double3& other) {
                    const double reach = radii_[i] + radii_[j] + kSkin;
                    if (j > i && lengthSquared(other - places_[i]) < reach * reach) pairs_.emplace_back(i, j);
                });
    }

    bool listsAreOld() const {
        if (listed_.empty()) return true;
        for (size_t i = 0; i < places_.size(); ++i)
            if (lengthSquared(places_[i] - listed_[i]) > kSkin * kSkin / 4) return true;
        return false;
    }

    /// The deepest overlap.
    double computeForces() {
        if (listsAreOld()) listPairs();
        std::fill(force_.begin(), force_.end(), Double3{});
        double deepest = 0;
        for (const auto& [i, j] : pairs_) {
            const Double3 apart = places_[j] - places_[i];
            const double distance = length(apart), overlap = radii_[i] + radii_[j] - distance;
            if (!(overlap > 0) || !(distance > 0)) continue;
            deepest = std::max(deepest, overlap);
            const Double3 push = (overlap / distance) * apart;
            force_[i] = force_[i] - push;
            force_[j] += push;
        }
        for (size_t i = 0; i < places_.size(); ++i) {
            const double distance = length(places_[i]), overlap = distance + radii_[i] - container_;
            if (!(overlap > 0)) continue;
            deepest = std::max(deepest, overlap);
            force_[i] = force_[i] - (overlap / distance) * places_[i];
        }
        return deepest;
    }

    void move() {
        double power = 0, force2 = 0, speed2 = 0;
        for (size_t i = 0; i < places_.size(); ++i) {
            power += dot(force_[i], velocity_[i]);
            force2 += lengthSquared(force_[i]);
            speed2 += lengthSquared(velocity_[i]);
        }
        if (power > 0) {
            if (++downhill_ > 5) {
                step_ = std::min(1.1 * step_, 0.6);
                turn_ *= 0.99;
            }
        } else {
            downhill_ = 0;
            step_ *= 0.5;
            turn_ = kTurn;
            std::fill(velocity_.begin(), velocity_.end(), Double3{});
        }
        const double along = force2 > 0 ? turn_ * std::sqrt(speed2 / force2) : 0;
        for (size_t i = 0; i < places_.size(); ++i) {
            if (power > 0) velocity_[i] = (1 - turn_) * velocity_[i] + along * force_[i];
            velocity_[i] += step_ * force_[i];
            places_[i] += step_ * velocity_[i];
        }
    }

    static constexpr double kTurn = 0.1;

    std::vector<double> radii_;
    double container_, largest_ = 0;
    std::vector<Double3> places_, listed_, velocity_, force_;
    std::vector<std::pair<uint32_t, uint32_t>> pairs_;
    double step_ = 0.1, turn_ = kTurn;
    int downhill_ = 0;
};

}  // namespace

std::vector<Double3> packSpheres(const std::vector<double>& radii, double container, uint64_t seed) {
    const double mean = std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
    std::vector<double> scaled = radii;
    for (double& radius : scaled) radius /= mean;
    std::vector<Double3> places = Relaxation(std::move(scaled), container / mean, seed).run();
    for (Double3& place : places) place = mean * place;
    return places;
}

}  // namespace demolish
