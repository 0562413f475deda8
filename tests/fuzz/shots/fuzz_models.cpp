// SPDX-License-Identifier: Apache-2.0
// The models by name, made from the unit tests' meshes.
#include "tests/fuzz/shots/fuzz_models.h"

#include <unistd.h>

#include <algorithm>
#include <functional>
#include <map>

#include "app/session/output_file.h"
#include "tests/unit/mesh/mesh_files.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::fuzz {
namespace {

TriangleMesh stretched(TriangleMesh mesh, const Double3& factor) {
    for (Double3& p : mesh.positions) p = {factor.x * p.x, factor.y * p.y, factor.z * p.z};
    return mesh;
}

/// `count` copies above each other (or beside, where `step` says so), apart from each other.
TriangleMesh row(const TriangleMesh& part, int count, const Double3& step) {
    TriangleMesh mesh = part;
    for (int k = 1; k < count; ++k) mesh = test::joined(mesh, part, {k * step.x, k * step.y, k * step.z});
    return mesh;
}

TriangleMesh hollowSphere(double cavity) {
    return test::joined(test::makeSphere(0.5, 3), test::turnedInsideOut(test::makeSphere(0.5 * cavity, 3)));
}

using Maker = std::function<TriangleMesh()>;

const std::map<std::string, Maker>& makers() {
    using namespace test;
    static const std::map<std::string, Maker> kMakers = {
        {"cube", [] { return makeCube(1); }},
        {"sphere", [] { return makeSphere(0.5, 3); }},
        {"coarse_sphere", [] { return makeSphere(0.5, 0); }},
        {"torus", [] { return makeTorus(0.5, 0.2, 32, 16); }},
        {"thin_torus", [] { return makeTorus(0.5, 0.03, 48, 8); }},
        {"vase_shell", [] { return makeVase(50, 30); }},
        {"fork", [] { return makeFork(0.5); }},
        {"cut_fork", [] { return makeFork(0); }},
        {"plate",
         [] {
             return stretched(makeCube(1), {1, 0.02, 1});
         }},
        {"wall",
         [] {
             return stretched(makeCube(1), {2, 1, 0.03});
         }},
        {"needle",
         [] {
             return stretched(makeCube(1), {0.02, 1, 0.02});
         }},
        {"disc",
         [] {
             return stretched(makeSphere(0.5, 3), {1, 0.05, 1});
         }},
        {"egg",
         [] {
             return stretched(makeSphere(0.5, 2), {0.7, 1.3, 0.7});
         }},
        {"hollow", [] { return hollowSphere(0.7); }},
        {"shell", [] { return hollowSphere(0.96); }},
        {"two_cubes",
         [] {
             return joined(makeCube(1), makeCube(0.5), {1.2, -0.25, 0});
         }},
        {"stack",
         [] {
             return row(makeCube(1), 12, {0, 1.05, 0});
         }},
        {"beads",
         [] {
             return row(makeSphere(0.5, 1), 8, {1.02, 0, 0});
         }},
        {"linked_rings",
         [] {
             TriangleMesh ring = makeTorus(0.5, 0.12, 24, 12);
             TriangleMesh other = ring;
             for (Double3& p : other.positions) p = {p.x, p.z, -p.y};
             return joined(ring, other, {0.5, 0, 0});
         }},
    };
    return kMakers;
}

double heightOf(const TriangleMesh& mesh) {
    const auto [low, high] =
        std::minmax_element(mesh.positions.begin(), mesh.positions.end(),
                            [](const Double3& a, const Double3& b) { return a.y < b.y; });
    return high->y - low->y;
}

std::vector<Subject> makeSubjects() {
    // Volumes to choose particle sizes by; the run itself takes those of the meshes.
    std::vector<Subject> all = {{"block", true, 1},
                                {"bunny", true, 0.005},
                                {"wolf", true, 0.105},
                                {"vase", true, 0.006},
                                {"column", true, 0.32}};
    for (const auto& [name, make] : makers()) {
        const TriangleMesh mesh = make();
        const double height = heightOf(mesh);
        all.push_back({name, false, test::signedVolume(mesh) / (height * height * height)});
    }
    return all;
}

}  // namespace

const std::vector<Subject>& subjects() {
    static const std::vector<Subject> kSubjects = makeSubjects();
    return kSubjects;
}

std::filesystem::path modelFile(const std::string& name, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / (name + ".obj");
    if (std::filesystem::exists(file)) return file;
    std::filesystem::create_directories(folder);
    writeTextFile(file, test::objText(makers().at(name)()));
    return file;
}

}  // namespace demolish::fuzz
