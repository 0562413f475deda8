// SPDX-License-Identifier: Apache-2.0
// Meshes that stand still in the solver's tests.
#pragma once
#include <cmath>

#include "sim_cuda/api/params.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::tests {

inline MeshShape meshShape(TriangleMesh mesh, const Double3& position, const Quaternion& rotation = {}) {
    return {makeColliderMesh(std::move(mesh), "test.obj", {}), 1, position, rotation};
}

/// Lower half of a ball of radius `outer` (m) about the origin, without the ball of radius `inner` in it.
inline TriangleMesh makeBowl(double outer, double inner, uint32_t sectors = 48, uint32_t rings = 24) {
    TriangleMesh mesh;
    const auto pole = [&](double radius) {
        mesh.positions.push_back({0, -radius, 0});
        return static_cast<uint32_t>(mesh.positions.size() - 1);
    };
    const auto ring = [&](double radius, uint32_t r) {
        const double down = 0.5 * 3.14159265358979 * r / rings;
        for (uint32_t s = 0; s < sectors; ++s) {
            const double round = 2 * 3.14159265358979 * s / sectors;
            mesh.positions.push_back({radius * std::sin(down) * std::cos(round), -radius * std::cos(down),
                                      radius * std::sin(down) * std::sin(round)});
        }
        return static_cast<uint32_t>(mesh.positions.size() - sectors);
    };
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
        mesh.triangles.push_back({a, b, c});
        mesh.corners.push_back({});
    };
    const auto join = [&](uint32_t below, uint32_t above) {
        for (uint32_t s = 0; s < sectors; ++s) {
            const uint32_t next = (s + 1) % sectors;
            add(below + s, above + s, above + next);
            add(below + s, above + next, below + next);
        }
    };
    const uint32_t bottom = pole(outer);
    uint32_t last = ring(outer, 1);
    for (uint32_t s = 0; s < sectors; ++s) add(bottom, last + s, last + (s + 1) % sectors);
    for (uint32_t r = 2; r <= rings; ++r) {
        const uint32_t now = ring(outer, r);
        join(last, now);
        last = now;
    }
    for (uint32_t r = rings; r >= 1; --r) {
        const uint32_t now = ring(inner, r);
        join(last, now);
        last = now;
    }
    const uint32_t hollow = pole(inner);
    for (uint32_t s = 0; s < sectors; ++s) add(hollow, last + (s + 1) % sectors, last + s);
    return mesh;
}

}  // namespace demolish::tests
