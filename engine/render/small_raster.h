// SPDX-License-Identifier: Apache-2.0
// Which samples a small triangle covers, as a rasteriser finds them (shaders/common/coverage.glsl): corners
// are rounded to a grid, and a sample on an edge belongs to one of the two triangles there. Plain numbers, no
// OpenGL; in a header, since a frame asks millions of times.
#pragma once
#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace demolish::engine {

inline constexpr int kGridBits = 8, kGridSteps = 1 << kGridBits;  ///< steps along a pixel

/// Of a triangle's corners on a picture; x and y in whole grid steps from its lower left corner.
struct FlatCorners {
    float x[3], y[3], depth[3];
};

struct PixelBox {
    int left, low, right, high;  ///< px; the latter two are inside
    int width() const { return right - left + 1; }
    int height() const { return high - low + 1; }
    bool isEmpty() const { return left > right || low > high; }
    void add(const PixelBox& box) {
        left = std::min(left, box.left);
        low = std::min(low, box.low);
        right = std::max(right, box.right);
        high = std::max(high, box.high);
    }
    void cutTo(int width, int height) {
        *this = {std::max(left, 0), std::max(low, 0), std::min(right, width - 1), std::min(high, height - 1)};
    }
    static PixelBox empty() { return {1 << 30, 1 << 30, -1, -1}; }
};

/// Depth along a triangle, never beyond that of its corners: the slope of a sliver is not known well.
class FlatDepth {
  public:
    /// `area`: twice the triangle's, grid steps, > 0.
    FlatDepth(const FlatCorners& c, float area)
        : x_(c.x[0]),
          y_(c.y[0]),
          depth_(c.depth[0]),
          least_(std::min({c.depth[0], c.depth[1], c.depth[2]})),
          most_(std::max({c.depth[0], c.depth[1], c.depth[2]})) {
        const float to_1 = c.depth[1] - c.depth[0], to_2 = c.depth[2] - c.depth[0];
        slope_x_ = (to_1 * (c.y[2] - c.y[0]) - to_2 * (c.y[1] - c.y[0])) / area;
        slope_y_ = (to_2 * (c.x[1] - c.x[0]) - to_1 * (c.x[2] - c.x[0])) / area;
    }
    float at(int x, int y) const {
        const float away_x = static_cast<float>(x) - x_, away_y = static_cast<float>(y) - y_;
        return std::clamp(depth_ + slope_x_ * away_x + slope_y_ * away_y, least_, most_);
    }
    /// Change along a pixel, along x or y, whichever is more.
    float steepness() const { return kGridSteps * std::max(std::abs(slope_x_), std::abs(slope_y_)); }
    float most() const { return most_; }

  private:
    float x_, y_, depth_, least_, most_, slope_x_, slope_y_;
};

/// A picture's samples, as a grid's steps inside each pixel.
struct PictureSamples {
    int width = 0, height = 0;  ///< px
    std::vector<glm::ivec2> at;
    bool operator==(const PictureSamples&) const = default;

    /// Pixels that may hold samples which a box of grid steps covers, cut to the picture.
    PixelBox pixelsOf(const glm::ivec2& offset, const PixelBox& steps) const {
        const auto up = [](int v) { return (v + kGridSteps - 1) >> kGridBits; };
        return {std::max(up(steps.left - offset.x), 0), std::max(up(steps.low - offset.y), 0),
                std::min((steps.right - offset.x) >> kGridBits, width - 1),
                std::min((steps.high - offset.y) >> kGridBits, height - 1)};
    }
};

/// Calls `visit(x, y, k, at_x, at_y)` for sample `k` of pixel x, y, which lies at_x, at_y grid steps from the
/// picture's corner, wherever a triangle that shows its front covers it. Its box is smaller than 64 px.
template <class Visit>
void coverSamples(const FlatCorners& c, const PictureSamples& samples, const Visit& visit) {
    int x[3], y[3], along_x[3], along_y[3], out[3];
    for (int k = 0; k < 3; ++k) {
        x[k] = static_cast<int>(c.x[k]);
        y[k] = static_cast<int>(c.y[k]);
    }
    for (int k = 0; k < 3; ++k) {
        const int to = k == 2 ? 0 : k + 1, edge_x = x[to] - x[k], edge_y = y[to] - y[k];
        along_x[k] = -edge_y;
        along_y[k] = edge_x;
        out[k] = edge_y < 0 || (edge_y == 0 && edge_x < 0) ? 0 : 1;  // left and upper edges are inside
    }
    const PixelBox steps{std::min({x[0], x[1], x[2]}), std::min({y[0], y[1], y[2]}),
                         std::max({x[0], x[1], x[2]}), std::max({y[0], y[1], y[2]})};
    for (size_t s = 0; s < samples.at.size(); ++s) {
        const glm::ivec2 offset = samples.at[s];
        const PixelBox box = samples.pixelsOf(offset, steps);
        for (int py = box.low; py <= box.high; ++py) {
            const int at_y = py * kGridSteps + offset.y;
            for (int px = box.left; px <= box.right; ++px) {
                const int at_x = px * kGridSteps + offset.x;
                const auto side = [&](int k) {
                    return along_y[k] * (at_y - y[k]) + along_x[k] * (at_x - x[k]) - out[k];
                };
                if ((side(0) | side(1) | side(2)) >= 0) visit(px, py, s, at_x, at_y);
            }
        }
    }
}

/// Puts a greater or lesser one in the place of a number, from any number of threads; the outcome does not
/// depend on their order.
template <class Number, class Before>
void putIf(Number& place, Number value, const Before& isBefore) {
    std::atomic_ref<Number> held(place);
    Number before = held.load(std::memory_order_relaxed);
    while (isBefore(before, value) && !held.compare_exchange_weak(before, value, std::memory_order_relaxed)) {
    }
}

}  // namespace demolish::engine
