// SPDX-License-Identifier: Apache-2.0
// Meshes filled with particles.
#include "tests/physics/models/packed_body.h"

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/authoring/solid_mesh.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::tests {
namespace {

std::shared_ptr<const BreakableBody> filled(const SolidMesh& mesh, uint32_t particles, uint64_t seed) {
    return fillWithParticles(mesh, {.particles = particles, .seed = seed, .draw_geometry = false});
}

}  // namespace

std::shared_ptr<const BreakableBody> boxBody(const Double3& sides, uint32_t particles, uint64_t seed) {
    TriangleMesh mesh = test::makeCube(1);
    for (Double3& p : mesh.positions) p = {sides.x * p.x, sides.y * (p.y + 0.5), sides.z * p.z};
    return filled(SolidMesh(std::move(mesh)), particles, seed);
}

std::shared_ptr<const BreakableBody> sphereBody(double diameter, uint32_t particles, uint64_t seed) {
    TriangleMesh mesh = test::makeSphere(diameter / 2, 4);
    for (Double3& p : mesh.positions) p.y += diameter / 2;
    return filled(SolidMesh(std::move(mesh)), particles, seed);
}

std::shared_ptr<const BreakableBody> modelBody(const std::string& name, double height, uint32_t particles,
                                               uint64_t seed) {
    const std::string file = std::string(DEMOLISH_SOURCE_DIR) + "/assets/models/" + name + ".obj";
    return filled(*loadSolidMesh(file, {.height = height}), particles, seed);
}

}  // namespace demolish::tests
