// SPDX-License-Identifier: Apache-2.0
// Meshes made by formula or read from files, kept for the whole test program.
#include "tests/unit/cells/test_bodies.h"

#include <filesystem>
#include <map>
#include <stdexcept>

#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/solid_checks.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {

namespace {

TriangleMesh madeMesh(const std::string& name) {
    if (name == "cube") return makeCube(1);
    if (name == "torus") return makeTorus(0.5, 0.2, 60, 30);
    if (name == "sphere") return makeSphere(0.5, 3);
    if (name == "vase") return makeVase(50, 30);
    if (name == "overlapping_boxes") return joined(makeCube(1), makeCube(1), {0.3, 0.41, 0.27});
    if (name == "hollow_box") return joined(makeCube(1), turnedInsideOut(makeCube(0.5)), {0.03, 0.02, 0.01});
    throw std::out_of_range("no test body " + name);
}

std::filesystem::path fileOf(const std::string& name) {
    const std::filesystem::path glmark2 = "/usr/share/glmark2/models";
    if (name == "bunny") return glmark2 / "bunny.obj";
    if (name == "asteroid-high" || name == "asteroid-low") return glmark2 / (name + ".3ds");
    if (name == "rabbit") return std::filesystem::path(DEMOLISH_SOURCE_DIR) / "assets/models/rabbit.obj";
    return {};
}

std::unique_ptr<QueriedMesh> make(const std::string& name) {
    const std::filesystem::path file = fileOf(name);
    if (file.empty()) return std::make_unique<QueriedMesh>(madeMesh(name));
    if (!std::filesystem::exists(file)) return nullptr;
    TriangleMesh mesh = importTriangles(file);
    requireSolid(mesh, file);
    return std::make_unique<QueriedMesh>(std::move(mesh));
}

}  // namespace

const QueriedMesh* testBody(const std::string& name) {
    static std::map<std::string, std::unique_ptr<QueriedMesh>> bodies;
    const auto known = bodies.find(name);
    return known != bodies.end() ? known->second.get() : bodies.emplace(name, make(name)).first->second.get();
}

}  // namespace demolish::test
