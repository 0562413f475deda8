// SPDX-License-Identifier: Apache-2.0
// The same as in shaders/common/corner_weights.glsl, but not kept inside the triangle: so a rasteriser has
// it.
#include "engine/render/surface_records.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <utility>

namespace demolish::engine {
namespace {

constexpr size_t kMostSamples = 4;

/// A triangle in the world, and the rays that meet it.
struct Corners {
    glm::vec3 from;  ///< from the first corner to the eye
    glm::vec3 to_1, to_2;

    /// Of the second and third corner where a ray from the eye meets the triangle's plane.
    glm::vec2 weightsAt(const glm::vec3& ray) const {
        const glm::vec3 across = glm::cross(ray, to_2);
        const float area = glm::dot(to_1, across);
        return glm::vec2(glm::dot(from, across), glm::dot(ray, glm::cross(from, to_1))) /
               (std::abs(area) > 1e-30f ? area : 1e-30f);
    }
};

uint32_t octahedralOf(glm::vec3 n) {
    n /= std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    const glm::vec2 folded((1 - std::abs(n.y)) * (n.x >= 0 ? 1.0f : -1.0f),
                           (1 - std::abs(n.x)) * (n.y >= 0 ? 1.0f : -1.0f));
    return glm::packSnorm2x16(n.z >= 0 ? glm::vec2(n) : folded);
}

SurfaceRecord recordOf(const TriangleSource& source, size_t triangle, const MeshMotion& motion,
                       const FrameUniforms& frame, glm::vec2 pixel) {
    const MeshVertex* v[3];
    for (size_t k = 0; k < 3; ++k) v[k] = &source.vertices[source.indices[3 * triangle + k]];
    const MeshTransform& t = motion.transformOf(motion.fragmentOf(v[0]->cell));  // of one fragment, all
    const glm::vec3 first = MeshMotion::moved(t, v[0]->position);
    const Corners corners{glm::vec3(frame.eye) - first, MeshMotion::moved(t, v[1]->position) - first,
                          MeshMotion::moved(t, v[2]->position) - first};
    const glm::vec2 per_pixel(2 * frame.viewport.z, 2 * frame.viewport.w);
    const glm::vec2 ndc = per_pixel * (pixel + 0.5f) - 1.0f;
    const glm::vec3 ray_right(frame.ray_right), ray_up(frame.ray_up);
    const glm::vec3 ray = glm::vec3(frame.ray_forward) + ndc.x * ray_right + ndc.y * ray_up;
    const glm::vec2 w = corners.weightsAt(ray), right = corners.weightsAt(ray + per_pixel.x * ray_right) - w,
                    up = corners.weightsAt(ray + per_pixel.y * ray_up) - w;
    const glm::vec3 edge_1 = v[1]->position - v[0]->position, edge_2 = v[2]->position - v[0]->position;
    const glm::vec3 weights(1 - w.x - w.y, w);
    glm::vec3 normal(0);
    glm::vec2 relief[3];
    for (int k = 0; k < 3; ++k) {
        normal += weights[k] * normalOf(v[k]->normal);
        relief[k] = glm::unpackHalf2x16(v[k]->place);
    }
    const float deeper_1 = relief[1].x - relief[0].x, deeper_2 = relief[2].x - relief[0].x;
    return {v[0]->position + w.x * edge_1 + w.y * edge_2,
            octahedralOf(rotated(t.rotation, normal)),
            {glm::packSnorm2x16(glm::vec2(t.rotation.x, t.rotation.y)),
             glm::packSnorm2x16(glm::vec2(t.rotation.z, t.rotation.w))},
            glm::packHalf2x16(weights.x * relief[0] + weights.y * relief[1] + weights.z * relief[2]),
            static_cast<uint32_t>(pixel.x) | static_cast<uint32_t>(pixel.y) << 16,
            right.x * edge_1 + right.y * edge_2,
            right.x * deeper_1 + right.y * deeper_2,
            up.x * edge_1 + up.y * edge_2,
            up.x * deeper_1 + up.y * deeper_2};
}

/// Calls `work(k, first)` for each sample of a pixel that shows something; `first` shows the same, and is k
/// where none before it does.
template <class Work>
void eachShown(std::span<const NamedSample> pixel, const Work& work) {
    std::array<uint32_t, kMostSamples> names;
    for (size_t k = 0; k < pixel.size(); ++k) names[k] = pixel[k].name;
    for (size_t k = 0; k < pixel.size(); ++k) {
        size_t first = 0;
        while (names[first] != names[k]) ++first;
        if (names[k] != 0) work(k, first);
    }
}

}  // namespace

/// Numbers of records of each row of pixels become places, and each part gets whole rows of blocks that are
/// drawn at once.
void SurfaceRecords::makeRoom() {
    constexpr size_t kBlock = 4;
    size_t row = 0;
    for (size_t part = 0; part < kParts; ++part) {
        auto next = static_cast<uint32_t>(row * kAcross);
        const uint32_t begin = next;
        for (auto& first : first_) next += std::exchange(first[part], next);
        const size_t rows = (next - begin + kAcross - 1) / kAcross;
        rows_[part] = {row, rows};
        row += (rows + kBlock - 1) / kBlock * kBlock;
    }
    records_.resize(row * kAcross);
}

void SurfaceRecords::make(std::span<NamedSample> named, int width, int samples, const PixelBox& box,
                          const std::array<TriangleSource, kParts>& sources, const MeshMotion& motion,
                          const FrameUniforms& frame) {
    first_.assign(static_cast<size_t>(std::max(box.high - box.low + 1, 0)), {});
    const auto of_pixel = static_cast<size_t>(samples);
    const auto samplesOf = [&](int x, int y) {
        const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
        return named.subspan(pixel * of_pixel, of_pixel);
    };
    const auto eachNamed = [&](const auto& work) {
        tbb::parallel_for(box.low, box.high + 1, [&](int y) {
            auto& first = first_[static_cast<size_t>(y - box.low)];
            for (int x = box.left; x <= box.right; ++x) {
                const std::span<NamedSample> shown = samplesOf(x, y);
                eachShown(shown, [&](size_t k, size_t alike) { work(first, shown, k, alike, x, y); });
            }
        });
    };
    const auto partOf = [](uint32_t name) { return (name & kInteriorBit) != 0 ? kInside : kOutside; };
    eachNamed([&](auto& count, auto shown, size_t k, size_t alike, int, int) {
        if (alike == k) ++count[partOf(shown[k].name)];
    });
    makeRoom();
    eachNamed([&](auto& next, auto shown, size_t k, size_t alike, int x, int y) {
        const uint32_t name = shown[k].name;
        const Part part = partOf(name);
        if (alike == k)
            records_[next[part]++] =
                recordOf(sources[part], (name & ~kInteriorBit) - 1, motion, frame, {x, y});
        shown[k].name = alike == k ? next[part] : shown[alike].name;
    });
}

}  // namespace demolish::engine
