// SPDX-License-Identifier: Apache-2.0
// Of the small triangles that may cover a sample of a picture those that lie behind others in all of their
// samples. Nothing is left out unless it is surely hidden, so that the picture stays as it was.
#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/sample_grid.h"

namespace demolish::engine {

/// Depth along a triangle on a picture.
class NearPlane {
  public:
    explicit NearPlane(const std::array<PicturePoint, 3>& corners);
    float at(float x, float y) const {
        return std::clamp(near_ + slope_x_ * (x - x_) + slope_y_ * (y - y_), least_, most_);
    }
    float unsure() const { return unsure_; }  ///< by which at() may be off
    float most() const { return most_; }

  private:
    float x_, y_, near_, slope_x_, slope_y_, least_, most_, unsure_;
};

/// How near is what surely covers a sample.
class NearestSurely {
  public:
    void clear(size_t samples) { near_.assign(samples, 0); }
    /// `near` > 0. From any number of threads; the outcome does not depend on their order.
    void put(uint32_t sample, float near) {
        std::atomic_ref<uint32_t> held(near_[sample]);
        const auto bits = std::bit_cast<uint32_t>(near);  // of positive numbers in the order of their values
        uint32_t before = held.load(std::memory_order_relaxed);
        while (before < bits && !held.compare_exchange_weak(before, bits, std::memory_order_relaxed)) {
        }
    }
    bool hides(uint32_t sample, float near) const { return std::bit_cast<float>(near_[sample]) > near; }

  private:
    std::vector<uint32_t> near_;
};

/// Triangles of one stretch that may show.
class Candidates {
  public:
    void clear();
    /// One that is never hidden.
    void addShown(const uint32_t (&corners)[3]) {
        triangles_.push_back({{corners[0], corners[1], corners[2]}, 0});
    }
    /// One that is no sliver; `cover` is of its places on `grid`.
    void add(const uint32_t (&corners)[3], const std::array<PicturePoint, 3>& places, const Cover& cover,
             const SampleGrid& grid, NearestSurely& nearest);
    /// Appends the corners of those that are not hidden, in their order.
    void keepSeen(const NearestSurely& nearest, std::vector<uint32_t>& indices) const;

  private:
    struct Candidate {
        uint32_t corners[3];
        uint32_t samples;  ///< how many of `samples_`; 0: never hidden
    };
    struct Sample {
        uint32_t index;
        float nearest;  ///< that the triangle may be there
    };
    std::vector<Candidate> triangles_;
    std::vector<Sample> samples_;
};

}  // namespace demolish::engine
