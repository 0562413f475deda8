// SPDX-License-Identifier: Apache-2.0
// Stretches of triangles go to all cores. A corner is fetched and moved once for all pictures, which stand
// beside each other in one matrix; corners that follow each other are often the same, so that each stretch
// remembers some.
#include "engine/render/small_triangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/render/mesh_motion.h"

namespace demolish::engine {
namespace {

constexpr uint32_t kStretch = 3 * 8192;  // indices
constexpr uint32_t kRemembered = 256, kNone = 0xffffffffu;
constexpr float kLargest = 24 * kGridSteps;         // grid steps; larger ones fill blocks of pixels anyway
constexpr float kFarthest = 16384.0f * kGridSteps;  // beyond it, places are not whole steps any more
constexpr float kNearest = 1e-6f;                   // of w

/// Four numbers that are worked on at once: x and y in grid steps, depth, and w.
using Lanes = float __attribute__((vector_size(16)));

Lanes lanesOf(const glm::vec4& v) {
    return Lanes{v.x, v.y, v.z, v.w};
}

/// x and y become whole steps: beside such a number there is no room for a fraction.
Lanes onGrid(const Lanes& place) {
    constexpr float kHuge = 1.5f * (1 << 23);
    const Lanes huge{kHuge, kHuge, 0, 0};
    return (place + huge) - huge;
}

/// A corner on every picture.
using Places = std::array<Lanes, SmallTriangles::kPictures>;

/// What puts corners onto a picture.
struct Projection {
    Lanes x, y, z, shift;
    Lanes placeOf(const glm::vec3& p) const { return x * p.x + y * p.y + z * p.z + shift; }
};
using Projections = std::array<Projection, SmallTriangles::kPictures>;

Places placesOf(const Projections& projections, const glm::vec3& p) {
    Places places;
    for (size_t k = 0; k < places.size(); ++k) places[k] = projections[k].placeOf(p);
    const float across = 1 / places[0][3];  // the sun's pictures are parallel
    places[0] *= Lanes{across, across, across, 1};
    for (Lanes& place : places) place = onGrid(place);
    return places;
}

Projections projectionsOf(const std::array<glm::mat4, SmallTriangles::kPictures>& to_grid,
                          const glm::mat4& motion) {
    Projections all;
    for (size_t k = 0; k < to_grid.size(); ++k) {
        const glm::mat4 moved = to_grid[k] * motion;
        all[k] = {lanesOf(moved[0]), lanesOf(moved[1]), lanesOf(moved[2]), lanesOf(moved[3])};
    }
    return all;
}

/// Clip space to grid steps.
glm::mat4 toGrid(const SmallTriangles::Target& target) {
    const glm::vec2 half = 0.5f * kGridSteps * glm::vec2(target.width, target.height);
    glm::mat4 steps = target.to_clip;
    for (int column = 0; column < 4; ++column) {
        steps[column].x = half.x * (target.to_clip[column].x + target.to_clip[column].w);
        steps[column].y = half.y * (target.to_clip[column].y + target.to_clip[column].w);
    }
    return steps;
}

class Corners {
  public:
    Corners(const MeshMotion& motion, std::span<const MeshVertex> vertices,
            const std::array<glm::mat4, SmallTriangles::kPictures>& to_grid)
        : motion_(motion), vertices_(vertices), to_grid_(to_grid) {
        index_.fill(kNone);
    }

    const Places& at(uint32_t index) {
        const uint32_t row = index % kRemembered;
        if (index_[row] != index) put(row, index);
        return places_[row];
    }

  private:
    [[gnu::noinline]] void put(uint32_t row, uint32_t index) {
        index_[row] = index;
        const MeshVertex& vertex = vertices_[index];
        follow(motion_.fragmentOf(vertex.cell));
        places_[row] = placesOf(projections_, vertex.position);
    }
    /// Corners that follow each other are mostly of one fragment.
    void follow(uint32_t fragment) {
        if (fragment == fragment_) return;
        fragment_ = fragment;
        projections_ = projectionsOf(to_grid_, MeshMotion::matrixOf(motion_.transformOf(fragment)));
    }

    const MeshMotion& motion_;
    std::span<const MeshVertex> vertices_;
    const std::array<glm::mat4, SmallTriangles::kPictures>& to_grid_;
    std::array<uint32_t, kRemembered> index_;
    std::array<Places, kRemembered> places_;
    uint32_t fragment_ = kNone;
    Projections projections_;
};

enum class Size { kNothing, kSmall, kLarge };

struct Flat {
    Lanes low, high;
    float area;
    FlatCorners corners(const Lanes& a, const Lanes& b, const Lanes& c) const {
        return {{a[0], b[0], c[0]}, {a[1], b[1], c[1]}, {a[2], b[2], c[2]}};
    }
    PixelBox steps() const {
        return {static_cast<int>(low[0]), static_cast<int>(low[1]), static_cast<int>(high[0]),
                static_cast<int>(high[1])};
    }
    PixelBox pixels() const {
        const PixelBox box = steps();
        return {box.left >> kGridBits, box.low >> kGridBits, box.right >> kGridBits, box.high >> kGridBits};
    }
};

/// Large is also what has no place on the picture for certain.
Size sizeOf(const Lanes& a, const Lanes& b, const Lanes& c, const PictureSamples& samples, Flat& flat) {
    const Lanes low_ab = a < b ? a : b, high_ab = a > b ? a : b;
    flat.low = low_ab < c ? low_ab : c;
    flat.high = high_ab > c ? high_ab : c;
    if (!(flat.low[3] > kNearest)) return Size::kLarge;
    const auto width = static_cast<float>(kGridSteps * samples.width);
    const auto height = static_cast<float>(kGridSteps * samples.height);
    if (flat.high[0] < 0 || flat.low[0] > width || flat.high[1] < 0 || flat.low[1] > height)
        return Size::kNothing;
    const Lanes box = flat.high - flat.low;
    if (!(box[0] <= kLargest && box[1] <= kLargest && flat.high[0] < kFarthest && flat.high[1] < kFarthest))
        return Size::kLarge;
    const Lanes to_b = b - a, to_c = c - a;
    flat.area = to_b[0] * to_c[1] - to_c[0] * to_b[1];
    if (!(flat.area > 0)) return Size::kNothing;
    const PixelBox steps = flat.steps();
    for (const glm::ivec2& offset : samples.at)
        if (!samples.pixelsOf(offset, steps).isEmpty()) return Size::kSmall;
    return Size::kNothing;
}

bool isBefore(const NamedSample& held, const NamedSample& value) {
    return std::bit_cast<uint64_t>(held) < std::bit_cast<uint64_t>(value);
}

/// Rows that were touched become `empty` again, or all where they do not fit.
template <class Element>
void clearRows(std::vector<Element>& elements, size_t size, bool fits, size_t row, const PixelBox& touched,
               const Element& empty) {
    if (!fits) return elements.assign(size, empty);
    if (touched.isEmpty()) return;
    std::fill(elements.begin() + static_cast<ptrdiff_t>(row * static_cast<size_t>(touched.low)),
              elements.begin() + static_cast<ptrdiff_t>(row * static_cast<size_t>(touched.high + 1)), empty);
}

/// The least step of a number between its neighbours there, as drivers offset depths of 32 bit.
float stepAt(float depth) {
    return std::ldexp(1.0f, std::ilogb(std::max(depth, 1e-30f)) - 23);
}

}  // namespace

struct SmallTriangles::Listed {
    TriangleSource triangles;
    uint32_t name_bits;
};

struct SmallTriangles::Search {
    const MeshMotion& motion;
    std::array<glm::mat4, kPictures> to_grid;
    float slopes, steps;
};

void SmallTriangles::clear(const std::array<Target, kPictures>& targets) {
    for (size_t k = 0; k < kPictures; ++k) {
        PictureSamples samples{targets[k].width, targets[k].height, {}};
        for (const glm::vec2& at : targets[k].samples)
            samples.at.emplace_back(glm::round(at * float{kGridSteps}));
        const bool fits = samples == samples_[k];
        samples_[k] = std::move(samples);
        const size_t row = samples_[k].at.size() * static_cast<size_t>(samples_[k].width);
        const size_t all = row * static_cast<size_t>(samples_[k].height);
        if (k == 0)
            clearRows(named_, all, fits, row, touched_[k], NamedSample{0, 0});
        else
            clearRows(depths_[k - 1], all, fits, row, touched_[k], 1.0f);
        touched_[k] = PixelBox::empty();
    }
}

void SmallTriangles::putNamed(const FlatCorners& corners, float area, uint32_t name) {
    const FlatDepth depth(corners, area);
    const PictureSamples& samples = samples_[0];
    coverSamples(corners, samples, [&](int x, int y, size_t k, int at_x, int at_y) {
        const auto pixel =
            static_cast<size_t>(y) * static_cast<size_t>(samples.width) + static_cast<size_t>(x);
        // Bits of positive numbers are in the order of their values.
        const NamedSample value{name, std::bit_cast<uint32_t>(depth.at(at_x, at_y))};
        putIf(named_[pixel * samples.at.size() + k], value, isBefore);
    });
}

void SmallTriangles::putDepth(const FlatCorners& corners, float area, size_t region, const Search& search) {
    const FlatDepth depth(corners, area);
    const float offset = search.slopes * depth.steepness() + search.steps * stepAt(depth.most());
    const PictureSamples& samples = samples_[region + 1];
    coverSamples(corners, samples, [&](int x, int y, size_t, int at_x, int at_y) {
        const auto texel =
            static_cast<size_t>(y) * static_cast<size_t>(samples.width) + static_cast<size_t>(x);
        const float there = std::clamp(depth.at(at_x, at_y) + offset, 0.0f, 1.0f);
        putIf(depths_[region][texel], there, [](float held, float value) { return value < held; });
    });
}

void SmallTriangles::findIn(const Search& search, const Listed& listed, size_t first, Found& found) {
    for (size_t k = 0; k < kPictures; ++k) {
        found.large[k].clear();
        found.touched[k] = PixelBox::empty();
    }
    const std::span<const uint32_t> indices = listed.triangles.indices;
    Corners corners(search.motion, listed.triangles.vertices, search.to_grid);
    const size_t end = std::min(indices.size(), first + kStretch);
    Flat flat;
    for (size_t i = first; i + 2 < end; i += 3) {
        const uint32_t abc[3] = {indices[i], indices[i + 1], indices[i + 2]};
        const Places a = corners.at(abc[0]), b = corners.at(abc[1]), c = corners.at(abc[2]);
        for (size_t k = 0; k < kPictures; ++k) {
            const Size size = sizeOf(a[k], b[k], c[k], samples_[k], flat);
            if (size == Size::kNothing) continue;
            const bool is_between = flat.low[2] > 0 && flat.high[2] < 1;
            if (size == Size::kLarge || (k == 0 && !is_between)) {  // the picture's ends cut triangles off
                found.large[k].insert(found.large[k].end(), abc, abc + 3);
                continue;
            }
            found.touched[k].add(flat.pixels());
            const FlatCorners flat_corners = flat.corners(a[k], b[k], c[k]);
            if (k == 0)
                putNamed(flat_corners, flat.area, (static_cast<uint32_t>(i / 3) + 1) | listed.name_bits);
            else
                putDepth(flat_corners, flat.area, k - 1, search);
        }
    }
}

void SmallTriangles::find(const FractureMesh& mesh, const std::array<Target, kPictures>& targets,
                          const FrameUniforms& frame, float slopes, float steps) {
    clear(targets);
    const MeshMotion motion(mesh);
    Search search{motion, {}, slopes, steps};
    for (size_t k = 0; k < kPictures; ++k) search.to_grid[k] = toGrid(targets[k]);
    const auto searchIn = [&](const Listed& listed, std::vector<Found>& stretches) {
        stretches.resize((listed.triangles.indices.size() + kStretch - 1) / kStretch);
        tbb::parallel_for(size_t{0}, stretches.size(),
                          [&](size_t k) { findIn(search, listed, k * kStretch, stretches[k]); });
        for (const Found& found : stretches)
            for (size_t k = 0; k < kPictures; ++k) touched_[k].add(found.touched[k]);
    };
    const ListReading outside_list = outsideOf(mesh), inside_list = insideOf(mesh);
    const TriangleSource outside{outside_list.vertices(), outside_list.indices()};
    const TriangleSource inside{inside_list.vertices(), inside_list.indices()};
    searchIn({outside, 0}, outside_);
    searchIn({inside, kInteriorBit}, inside_);
    for (size_t k = 0; k < kPictures; ++k) touched_[k].cutTo(samples_[k].width, samples_[k].height);
    records_.make(named_, targets[0].width, static_cast<int>(samples_[0].at.size()), touched_[0],
                  {outside, inside}, motion, frame);
    gather(&SeenList::exterior, outside_);
    gather(&SeenList::interior, inside_);
}

void SmallTriangles::gather(TriangleList SeenList::*side, const std::vector<Found>& stretches) {
    for (size_t k = 0; k < kPictures; ++k)
        (large_[k].*side)
            .fill(
                stretches, [&](const Found& found) -> const auto& { return found.large[k]; });
}

}  // namespace demolish::engine
