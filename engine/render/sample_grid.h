// SPDX-License-Identifier: Apache-2.0
// Where a picture takes its samples, and whether a triangle may cover one of them. Plain numbers, no OpenGL;
// in a header, since a frame asks millions of times.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace demolish::engine {

/// A place on a picture, px from its lower left corner; in front of the viewer where w > 0.
struct PicturePoint {
    float x, y, w;
};

/// By how much a corner may come out elsewhere where it is drawn, px.
inline constexpr float kPlaceError = 1.0f / 64;

class SampleGrid {
  public:
    /// `to_clip`: from the world; `samples` inside each pixel, 0..1, at least one.
    SampleGrid(const glm::mat4& to_clip, int width, int height,
               std::vector<glm::vec2> samples = {{0.5f, 0.5f}})
        : to_clip_(to_clip),
          half_{0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height)},
          samples_(std::move(samples)) {}

    PicturePoint placeOf(const glm::vec3& world) const {
        const glm::vec4 clip = to_clip_ * glm::vec4(world, 1);
        const float across = 1 / clip.w;
        return {half_.x + half_.x * clip.x * across, half_.y + half_.y * clip.y * across, clip.w};
    }

    /// Whether a triangle of these corners may cover a sample of the picture, and, unless `both_sides`, shows
    /// its front there: counter-clockwise. True where it is not sure: what a rasteriser draws is never
    /// denied.
    bool mayShow(const PicturePoint& a, const PicturePoint& b, const PicturePoint& c, bool both_sides) const;

  private:
    struct Box {
        float left, right, low, high;
    };
    /// Positive on the inner side of a triangle that shows its front.
    struct Edge {
        float x, y, along_x, along_y, slack;
        Edge(const PicturePoint& from, const PicturePoint& to)
            : x(from.x),
              y(from.y),
              along_x(to.x - from.x),
              along_y(to.y - from.y),
              slack(kPlaceError * (std::abs(along_x) + std::abs(along_y))) {}
        bool keeps(float at_x, float at_y) const {
            return along_x * (at_y - y) - along_y * (at_x - x) >= -slack;
        }
    };
    bool holdsSample(const Box& box) const;
    bool coversSample(const Box& box, const Edge (&edges)[3]) const;

    glm::mat4 to_clip_;
    glm::vec2 half_;  ///< px, of width and height
    std::vector<glm::vec2> samples_;
};

inline bool SampleGrid::holdsSample(const Box& box) const {
    for (const glm::vec2& at : samples_)
        if (std::floor(box.right - at.x) >= std::ceil(box.left - at.x) &&
            std::floor(box.high - at.y) >= std::ceil(box.low - at.y))
            return true;
    return false;
}

inline bool SampleGrid::coversSample(const Box& box, const Edge (&edges)[3]) const {
    for (const glm::vec2& at : samples_)
        for (float y = std::ceil(box.low - at.y) + at.y; y <= box.high; y += 1)
            for (float x = std::ceil(box.left - at.x) + at.x; x <= box.right; x += 1)
                if (edges[0].keeps(x, y) && edges[1].keeps(x, y) && edges[2].keeps(x, y)) return true;
    return false;
}

inline bool SampleGrid::mayShow(const PicturePoint& a, const PicturePoint& b, const PicturePoint& c,
                                bool both_sides) const {
    constexpr float kNearest = 1e-6f;     // of w; nearer corners have no place on the picture
    constexpr float kLargestBox = 4;      // px; what is larger covers a sample nearly always
    constexpr float kFarthest = 1048576;  // px; beyond it, places are too coarse
    if (!(std::min({a.w, b.w, c.w}) > kNearest)) return true;
    const Box box{std::min({a.x, b.x, c.x}) - kPlaceError, std::max({a.x, b.x, c.x}) + kPlaceError,
                  std::min({a.y, b.y, c.y}) - kPlaceError, std::max({a.y, b.y, c.y}) + kPlaceError};
    if (box.right < 0 || box.left > 2 * half_.x || box.high < 0 || box.low > 2 * half_.y) return false;
    const float across = box.right - box.left, up = box.high - box.low;
    if (!(across + up < kFarthest)) return true;
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    const float unsure = 2 * kPlaceError * (across + up);
    if (!both_sides && area < -unsure) return false;
    if (across > kLargestBox || up > kLargestBox) return true;
    if (!holdsSample(box)) return false;
    if (std::abs(area) <= unsure) return true;
    if (area > 0) return coversSample(box, {{a, b}, {b, c}, {c, a}});
    return coversSample(box, {{a, c}, {c, b}, {b, a}});
}

}  // namespace demolish::engine
