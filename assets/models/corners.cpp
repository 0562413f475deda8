// SPDX-License-Identifier: Apache-2.0
// Corner attributes for rendering.
#include "assets/models/corners.h"

#include <algorithm>

namespace demolish::sculptor {
namespace {

constexpr double kPi = 3.14159265358979323846;

double angleBetween(Vec3 a, Vec3 b) {
    return std::atan2(length(cross(a, b)), dot(a, b));
}

}  // namespace

CornerNormals cornerNormals(const Surface& surface, double crease_degrees) {
    const auto& [positions, triangles] = surface;
    std::vector<std::vector<std::uint32_t>> fans(positions.size());
    std::vector<Vec3> face_normals;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        face_normals.push_back(normalized(areaNormal(surface, triangles[t])));
        for (const std::uint32_t v : triangles[t]) fans[v].push_back(t);
    }
    const auto angleAt = [&](std::uint32_t t, std::uint32_t v) {
        const Triangle& tri = triangles[t];
        const int i = tri[0] == v ? 0 : tri[1] == v ? 1 : 2;
        const Vec3 p = positions[v];
        return angleBetween(positions[tri[(i + 1) % 3]] - p, positions[tri[(i + 2) % 3]] - p);
    };
    // A hair more than the crease, so that a plane cut into triangles stays one plane.
    const double least_cosine = std::cos(std::min(180.0, crease_degrees + 0.1) * kPi / 180);
    CornerNormals normals(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t v = triangles[t][i];
            Vec3 sum;
            for (const std::uint32_t other : fans[v])
                if (other == t || crease_degrees >= 180 ||
                    dot(face_normals[t], face_normals[other]) >= least_cosine)
                    sum = sum + angleAt(other, v) * face_normals[other];
            normals[t][i] = normalized(sum);
        }
    return normals;
}

CornerUvs sphericalUvs(const Surface& surface) {
    Vec3 low = surface.positions.front(), high = low;
    for (const Vec3 p : surface.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 middle = 0.5 * (low + high);
    CornerUvs uvs;
    for (const Triangle& t : surface.triangles) {
        std::array<std::array<double, 2>, 3> uv;
        for (int i = 0; i < 3; ++i) {
            const Vec3 d = surface.positions[t[i]] - middle;
            uv[i] = {0.5 + std::atan2(d.x, d.z) / (2 * kPi),
                     0.5 + std::atan2(d.y, std::hypot(d.x, d.z)) / kPi};
        }
        const double largest = std::max({uv[0][0], uv[1][0], uv[2][0]});
        for (auto& corner : uv)
            if (largest - corner[0] > 0.5) corner[0] += 1;
        uvs.push_back(uv);
    }
    return uvs;
}

}  // namespace demolish::sculptor
