// SPDX-License-Identifier: Apache-2.0
// The shots of the study, and one case of it.
#include "tests/physics/models/threshold_study.h"

#include <cmath>
#include <fstream>

#include "app/session/scene_file.h"
#include "app/session/shot_setup.h"
#include "tests/physics/models/sheet_fits.h"
#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::tests {
namespace {

/// A ball of 1 m, as a mesh file like any other.
std::filesystem::path writeSphere(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const TriangleMesh mesh = test::makeSphere(0.5, 4);
    const std::filesystem::path file = folder / "sphere.obj";
    std::ofstream out(file);
    out.precision(9);
    for (const Double3& p : mesh.positions) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (const auto& t : mesh.triangles)
        out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    return file;
}

/// Stands on a point, so that nothing is to settle. Softened like the column, the other body of that size.
Shot sphereShot(const std::filesystem::path& folder) {
    Shot shot = loadScene("block");
    shot.scene = "sphere";
    shot.model = writeSphere(folder);
    shot.strength_row = "sphere";
    shot.settle_time = 0;
    shot.material = Material{};
    shot.material.critical_velocity = 4;
    shot.impact.direction = {-1, 0, 0};
    shot.impact.height_fraction = 0.5;
    shot.impact.tilt = {};
    return shot;
}

/// The block's scene has no tilt: a cube that is dropped flat is crushed all over its face.
Shot cubeShot() {
    Shot shot = loadScene("block");
    shot.material.tough_cells = 40;
    shot.material.weibull_modulus = 0;
    shot.impact.tilt = {0.3, 0, 0.4};
    return shot;
}

}  // namespace

std::vector<StudyShot> studyShots(const std::filesystem::path& folder) {
    struct Row {
        const char* body;
        Shot shot;
        double drop, ball;
    };
    const Row rows[] = {{"sphere", sphereShot(folder), 1, 12},    {"cube", cubeShot(), 1, 5},
                        {"rabbit", loadScene("bunny"), 0.6, 3.5}, {"column", loadScene("column"), 0.3, 0.7},
                        {"vase", loadScene("vase"), 0.2, 0.45},   {"wolf", loadScene("wolf"), 0.7, 0.45}};
    std::vector<StudyShot> shots;
    for (const Row& row : rows)
        for (const bool drop : {true, false}) {
            Shot shot = row.shot;
            shot.impact.kind = drop ? ImpactKind::kDrop : ImpactKind::kBall;
            shots.push_back({row.body, drop ? "drop" : "ball", trialShot(shot), drop ? row.drop : row.ball});
        }
    return shots;
}

StudyShot sphereDrop(const std::filesystem::path& folder, double tough_factor) {
    StudyShot study{"sphere", "drop", trialShot(sphereShot(folder)), 1};
    study.shot.impact.kind = ImpactKind::kDrop;
    study.shot.material.tough_cells = tough_factor > 1 ? 40 : 0;
    study.shot.material.tough_factor = std::max(1.0, tough_factor);
    study.usual_share = tough_factor > 1 ? 1.0 : 0.6;
    return study;
}

double StudyResult::spread() const {
    const double count = static_cast<double>(threshold.packings.size());
    if (count < 2) return 0;
    double sum = 0;
    for (const Bracket& bracket : threshold.packings)
        sum += std::pow(bracket.threshold() - threshold.velocity, 2);
    return std::sqrt(sum / (count - 1)) / threshold.velocity;
}

StudyResult runCase(const StudyCase& wanted) {
    Shot shot = wanted.shot->shot;
    shot.fineness.particles = wanted.particles;
    shot.seed += wanted.first_packing;
    const auto mesh = loadSolidMesh(shot.model, {.height = shot.height});
    const auto packings = fillPackings(shot, *mesh, wanted.packings, wanted.trial.on_gpu, {});
    const ImpactTrial trial(shot, packings[0], wanted.trial);
    StudyResult result;
    result.size_ratio = diameterOverSpacing(static_cast<double>(packings[0]->particles.size()));
    result.body_mass = trial.bodyMass();
    result.ball_mass = trial.ballMass();
    result.substeps = trial.setup().params.substeps;
    result.threshold = measureThreshold(shot, packings,
                                        {.tolerance = wanted.tolerance,
                                         .guess = wanted.shot->usual_share * shot.material.critical_velocity,
                                         .trial = wanted.trial},
                                        {});
    return result;
}

}  // namespace demolish::tests
