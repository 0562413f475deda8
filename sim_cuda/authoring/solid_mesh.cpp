// SPDX-License-Identifier: Apache-2.0
// Loads a solid and answers what sizes of particles it can take.
#include "sim_cuda/authoring/solid_mesh.h"

#include <cmath>
#include <cstdio>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/mesh_checks.h"
#include "sim_cuda/authoring/model_refusal.h"
#include "sim_cuda/authoring/solid_checks.h"

namespace demolish {

SolidMesh::SolidMesh(TriangleMesh mesh) : mesh_(std::move(mesh)), queries_(mesh_), grid_(mesh_, queries_) {
    const Bounds bounds = boundsOf(mesh_.positions);
    info_ = {mesh_.name,
             mesh_.triangles.size(),
             mesh_.positions.size(),
             enclosedVolume(mesh_),
             surfaceArea(mesh_),
             bounds.lower,
             bounds.upper};
}

SolidMesh::SolidMesh(RepairedMesh repaired, RepairMode mode, std::shared_ptr<const ModelLooks> looks)
    : SolidMesh(std::move(repaired.mesh)) {
    looks_ = std::move(looks);
    repair_ = repaired.report;
    source_ = std::move(repaired.source);
    may_remesh_ =
        (mode == RepairMode::kAuto || mode == RepairMode::kRemesh) && repair_.remeshed == RemeshCause::kNone;
}

std::shared_ptr<const SolidMesh> SolidMesh::withNewSurface() const {
    if (!may_remesh_) return nullptr;
    std::call_once(remesh_once_, [this] {
        RepairedMesh surface = demolish::withNewSurface({mesh_, source_, repair_}, RemeshCause::kCells);
        if (isSolid(surface.mesh))
            remeshed_ = std::make_shared<const SolidMesh>(std::move(surface), RepairMode::kOff, looks_);
    });
    return remeshed_;
}

std::shared_ptr<const SolidMesh> makeSolidMesh(TriangleMesh mesh, const std::filesystem::path& file,
                                               const MeshPlacement& placement,
                                               std::shared_ptr<const ModelLooks> looks) {
    if (mesh.triangles.empty()) refuseModel(file, kNoTriangles);
    if (placement.part.up == UpAxis::kZ) turnZUp(mesh);
    // Of the file's mesh, whatever the repair adds.
    const double scale = placementScale(boundsOf(mesh.positions).size(), placement);
    RepairOptions options = placement.repair;
    options.thickness /= scale;
    RepairedMesh repaired = repairMesh(std::move(mesh), options);
    repaired.report.thickness *= scale;
    requireSolid(repaired.mesh, file);
    standOnFloor(repaired.mesh, file, scale);
    return std::make_shared<const SolidMesh>(std::move(repaired), options.mode, std::move(looks));
}

std::shared_ptr<const SolidMesh> loadSolidMesh(const std::filesystem::path& file,
                                               const MeshPlacement& placement) {
    ImportedModel model = importModel(file, placement.part.node);
    return makeSolidMesh(std::move(model.mesh), file, placement, std::move(model.looks));
}

const SolidMeshInfo& meshInfo(const SolidMesh& mesh) {
    return mesh.info();
}

const RepairReport& repairReport(const SolidMesh& mesh) {
    return mesh.repair();
}

const ModelLooks* modelLooks(const SolidMesh& mesh) {
    return mesh.looks().get();
}

uint32_t particlesForSize(const SolidMesh& mesh, double particle_size_m) {
    const SolidMeshInfo& info = mesh.info();
    const double count = std::round(info.volume / (particle_size_m * particle_size_m * particle_size_m));
    if (particle_size_m > 0 && count >= kMinParticles && count <= kMaxParticles) return uint32_t(count);
    char sentence[256];
    std::snprintf(
        sentence, sizeof sentence,
        "A particle size of %g m is out of range for the model '%.100s'; choose one from %.3g m to %.3g m.",
        particle_size_m, info.name.c_str(), std::cbrt(info.volume / kMaxParticles) * 1.002,
        std::cbrt(info.volume / kMinParticles) * 0.998);
    throw UsageError(sentence);
}

}  // namespace demolish
