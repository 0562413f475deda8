// SPDX-License-Identifier: Apache-2.0
// Where a picture takes its samples, and which of them a triangle may cover, or surely covers. Plain numbers,
// no OpenGL; in a header, since a frame asks millions of times.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

namespace demolish::engine {

/// By how much a corner may come out elsewhere where it is drawn, px: rasterisers round to 1/256 px.
inline constexpr float kSnapError = 1.0f / 512 + 1.0f / 2048;
/// Share of the numbers that were added up by which their sum may come out otherwise.
inline constexpr float kRoundError = 5e-7f;

/// A place on a picture, px from its lower left corner; in front of the viewer where w > 0.
struct PicturePoint {
    float x, y, w;
    float near = 0;             ///< as a reversed depth buffer has it: the greater the nearer
    float unsure = kSnapError;  ///< px, by which it may come out elsewhere
    float near_unsure = 0;      ///< likewise, of `near`
};

/// Of a triangle on a picture that shows its front: positive on the inner side.
struct PictureEdge {
    float x, y, along_x, along_y, slack;
    static PictureEdge between(const PicturePoint& from, const PicturePoint& to, float unsure) {
        const float along_x = to.x - from.x, along_y = to.y - from.y;
        return {from.x, from.y, along_x, along_y, unsure * (std::abs(along_x) + std::abs(along_y))};
    }
    float sideOf(float at_x, float at_y) const { return along_x * (at_y - y) - along_y * (at_x - x); }
};

/// Which samples of a picture a triangle may cover, if they are few (kSamples). Not filled beforehand, since
/// a frame asks millions of times.
struct Cover {
    enum class Kind { kNothing, kSamples, kAnything };
    float left, right, low, high;  ///< px
    PictureEdge edges[3];
    bool is_sliver;  ///< so thin that all samples in the box may be covered, and none surely is

    bool mayCover(float x, float y) const {
        return is_sliver ||
               (edges[0].sideOf(x, y) >= -edges[0].slack && edges[1].sideOf(x, y) >= -edges[1].slack &&
                edges[2].sideOf(x, y) >= -edges[2].slack);
    }
    bool surelyCovers(float x, float y) const {
        return !is_sliver && edges[0].sideOf(x, y) > edges[0].slack &&
               edges[1].sideOf(x, y) > edges[1].slack && edges[2].sideOf(x, y) > edges[2].slack;
    }
};

/// Puts points onto a picture: a motion, and the way to the picture after it, in one.
class Projection {
  public:
    Projection() = default;
    PicturePoint placeOf(const glm::vec3& rest) const {
        const float size = size_of_motion_ + std::abs(rest.x) + std::abs(rest.y) + std::abs(rest.z);
        const float w = is_parallel_ ? 1 : along(w_, rest), across = is_parallel_ ? 1 : 1 / w;
        const float near = along(near_, rest) * across;
        const float error = kRoundError * size * std::abs(across);
        return {along(x_, rest) * across,
                along(y_, rest) * across,
                w,
                near,
                kSnapError + pixels_ * error,
                std::abs(near) * (depths_ * error + 4 * kRoundError) + nears_ * error};
    }

  private:
    friend class SampleGrid;
    static float along(const glm::vec4& row, const glm::vec3& p) {
        return row.x * p.x + row.y * p.y + row.z * p.z + row.w;
    }
    glm::vec4 x_{0}, y_{0}, near_{0}, w_{0};  ///< px times w, and as PicturePoint has it
    float pixels_ = 0;                        ///< px that a metre makes at w = 1, at most
    float depths_ = 0, nears_ = 0;            ///< change of w, and of `near` times w, for a metre, at most
    float size_of_motion_ = 0;                ///< m, of the numbers that are added
    bool is_parallel_ = false;                ///< w is 1 everywhere
};

class SampleGrid {
  public:
    /// `to_clip`: from the world; `samples` inside each pixel, 0..1, at least one.
    SampleGrid(const glm::mat4& to_clip, int width, int height,
               std::vector<glm::vec2> samples = {{0.5f, 0.5f}});

    /// Places of what `motion` has moved: rotated, shrunk, and put elsewhere.
    Projection projectionOf(const glm::mat4& motion) const;

    /// kNothing where a triangle of these corners covers no sample of the picture, or, unless `both_sides`,
    /// shows its back there: clockwise. Never where it is not sure: what a rasteriser draws is never denied.
    Cover::Kind findCover(const PicturePoint& a, const PicturePoint& b, const PicturePoint& c,
                          bool both_sides, Cover& cover) const;
    bool mayShow(const PicturePoint& a, const PicturePoint& b, const PicturePoint& c, bool both_sides) const {
        Cover cover;
        return findCover(a, b, c, both_sides, cover) != Cover::Kind::kNothing;
    }

    /// All samples of the picture.
    size_t sampleCount() const { return width_ * static_cast<size_t>(size_.y) * samples_.size(); }
    /// Calls `visit(x, y, index)` for the samples in a box until it says true, and says whether it did;
    /// `index` is below sampleCount().
    template <class Visit>
    bool anySample(const Cover& cover, const Visit& visit) const;

  private:
    glm::mat4 to_clip_;
    glm::vec2 size_;  ///< px
    size_t width_;
    std::vector<glm::vec2> samples_;
    float pixels_, depths_, nears_, size_of_shift_;  ///< as Projection has them; m, of what the matrix adds
};

inline SampleGrid::SampleGrid(const glm::mat4& to_clip, int width, int height, std::vector<glm::vec2> samples)
    : to_clip_(to_clip),
      size_{static_cast<float>(width), static_cast<float>(height)},
      width_(static_cast<size_t>(width)),
      samples_(std::move(samples)) {
    const auto steepness = [&](int row) {
        return std::abs(to_clip[0][row]) + std::abs(to_clip[1][row]) + std::abs(to_clip[2][row]);
    };
    nears_ = steepness(2);
    depths_ = steepness(3);
    pixels_ = 0.5f * std::max(size_.x * (steepness(0) + depths_), size_.y * (steepness(1) + depths_));
    size_of_shift_ = 0;
    for (const int row : {0, 1, 3})
        if (steepness(row) > 0)
            size_of_shift_ = std::max(size_of_shift_, std::abs(to_clip[3][row]) / steepness(row));
}

inline Projection SampleGrid::projectionOf(const glm::mat4& motion) const {
    const glm::mat4 to_clip = to_clip_ * motion;
    const auto row = [&](int k) {
        return glm::vec4(to_clip[0][k], to_clip[1][k], to_clip[2][k], to_clip[3][k]);
    };
    Projection p;
    p.near_ = row(2);
    p.w_ = row(3);
    p.x_ = 0.5f * size_.x * (row(0) + p.w_);
    p.y_ = 0.5f * size_.y * (row(1) + p.w_);
    p.pixels_ = pixels_;
    p.depths_ = depths_;
    p.nears_ = nears_;
    const glm::vec4& to = motion[3];
    p.size_of_motion_ = size_of_shift_ + std::abs(to.x) + std::abs(to.y) + std::abs(to.z);
    p.is_parallel_ = depths_ == 0 && to_clip_[3][3] == 1;
    return p;
}

template <class Visit>
inline bool SampleGrid::anySample(const Cover& cover, const Visit& visit) const {
    for (size_t k = 0; k < samples_.size(); ++k) {
        const glm::vec2 at = samples_[k];
        const float first = std::ceil(std::max(cover.left - at.x, 0.0f));
        const float last = std::min(cover.right - at.x, size_.x - 1);
        const float highest = std::min(cover.high - at.y, size_.y - 1);
        for (float y = std::ceil(std::max(cover.low - at.y, 0.0f)); y <= highest; y += 1)
            for (float x = first; x <= last; x += 1) {
                const size_t pixel = static_cast<size_t>(y) * width_ + static_cast<size_t>(x);
                if (visit(x + at.x, y + at.y, pixel * samples_.size() + k)) return true;
            }
    }
    return false;
}

inline Cover::Kind SampleGrid::findCover(const PicturePoint& a, const PicturePoint& b, const PicturePoint& c,
                                         bool both_sides, Cover& cover) const {
    constexpr float kNearest = 1e-6f;     // of w; nearer corners have no place on the picture
    constexpr float kLargestBox = 4;      // px; what is larger covers a sample nearly always
    constexpr float kFarthest = 1048576;  // px; beyond it, places are too coarse
    if (!(std::min({a.w, b.w, c.w}) > kNearest)) return Cover::Kind::kAnything;
    const float unsure = std::max({a.unsure, b.unsure, c.unsure});
    cover.left = std::min({a.x, b.x, c.x}) - unsure;
    cover.right = std::max({a.x, b.x, c.x}) + unsure;
    cover.low = std::min({a.y, b.y, c.y}) - unsure;
    cover.high = std::max({a.y, b.y, c.y}) + unsure;
    const float across = cover.right - cover.left, up = cover.high - cover.low;
    if (cover.right < 0 || cover.left > size_.x || cover.high < 0 || cover.low > size_.y)
        return Cover::Kind::kNothing;
    if (!(across + up < kFarthest)) return Cover::Kind::kAnything;
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    const float least = 2 * unsure * (across + up);
    if (!both_sides && area < -least) return Cover::Kind::kNothing;
    if (across > kLargestBox || up > kLargestBox) return Cover::Kind::kAnything;
    if (!anySample(cover, [](float, float, size_t) { return true; })) return Cover::Kind::kNothing;
    cover.is_sliver = !(std::abs(area) > least);
    const PicturePoint &second = area > 0 ? b : c, &third = area > 0 ? c : b;
    cover.edges[0] = PictureEdge::between(a, second, unsure);
    cover.edges[1] = PictureEdge::between(second, third, unsure);
    cover.edges[2] = PictureEdge::between(third, a, unsure);
    const bool may = anySample(cover, [&](float x, float y, size_t) { return cover.mayCover(x, y); });
    return may ? Cover::Kind::kSamples : Cover::Kind::kNothing;
}

}  // namespace demolish::engine
