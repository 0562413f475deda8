// SPDX-License-Identifier: Apache-2.0
// Bodies that stand close to each other: contact spheres come from the seeds of one body, and may reach into
// the next one, the more so the coarser the bodies are.
#include <algorithm>
#include <cmath>

#include "sim_cuda/solver/scene_tables.h"

namespace demolish {
namespace {

/// m, about the contact spheres of one body.
struct Box {
    Vec3<double> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};

bool overlap(const Box& a, const Box& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y &&
           a.low.z < b.high.z && b.low.z < a.high.z;
}

Box boxAbout(const Vec3<double>& at, double radius) {
    return {{at.x - radius, at.y - radius, at.z - radius}, {at.x + radius, at.y + radius, at.z + radius}};
}

void widen(Box& box, const Box& by) {
    box.low = {std::min(box.low.x, by.low.x), std::min(box.low.y, by.low.y), std::min(box.low.z, by.low.z)};
    box.high = {std::max(box.high.x, by.high.x), std::max(box.high.y, by.high.y),
                std::max(box.high.z, by.high.z)};
}

/// Particles whose spheres reach into the box of another body, by ascending x.
std::vector<uint32_t> nearOthers(const SceneTables& tables) {
    std::vector<Box> boxes(tables.bodies);
    const auto sphere = [&](uint32_t i) { return boxAbout(tables.position[i], tables.contact_radius[i]); };
    const auto count = static_cast<uint32_t>(tables.position.size());
    for (uint32_t i = 0; i < count; ++i) widen(boxes[tables.owner[i]], sphere(i));
    std::vector<std::vector<uint32_t>> close(tables.bodies);
    for (uint32_t a = 0; a < tables.bodies; ++a)
        for (uint32_t b = 0; b < tables.bodies; ++b)
            if (a != b && overlap(boxes[a], boxes[b])) close[a].push_back(b);
    std::vector<uint32_t> near;
    for (uint32_t i = 0; i < count; ++i) {
        const auto reaches = [&](uint32_t body) { return overlap(sphere(i), boxes[body]); };
        if (std::any_of(close[tables.owner[i]].begin(), close[tables.owner[i]].end(), reaches))
            near.push_back(i);
    }
    std::sort(near.begin(), near.end(),
              [&](uint32_t a, uint32_t b) { return tables.position[a].x < tables.position[b].x; });
    return near;
}

}  // namespace

void keepBodiesApart(SceneTables& tables) {
    constexpr double kLeastShare = 0.05;  // a sphere stays a sphere, even where bodies stand in each other
    const std::vector<uint32_t> near = nearOthers(tables);
    const std::vector<double> wanted = tables.contact_radius;
    for (size_t a = 0; a < near.size(); ++a)
        for (size_t b = a + 1; b < near.size(); ++b) {
            const uint32_t i = near[a], j = near[b];
            const Vec3<double> apart = tables.position[j] - tables.position[i];
            if (apart.x > wanted[i] + tables.largest_radius) break;
            if (tables.owner[i] == tables.owner[j]) continue;
            const double share = std::max(kLeastShare, length(apart) / (wanted[i] + wanted[j]));
            tables.contact_radius[i] = std::min(tables.contact_radius[i], share * wanted[i]);
            tables.contact_radius[j] = std::min(tables.contact_radius[j], share * wanted[j]);
        }
    tables.largest_radius = *std::max_element(tables.contact_radius.begin(), tables.contact_radius.end());
}

}  // namespace demolish
