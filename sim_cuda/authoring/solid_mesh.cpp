// SPDX-License-Identifier: Apache-2.0
// Loads a solid and answers what sizes of particles it can take.
#include "sim_cuda/authoring/solid_mesh.h"

#include <cmath>
#include <cstdio>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/bounds.h"
#include "sim_cuda/authoring/mesh_checks.h"
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

std::shared_ptr<const SolidMesh> makeSolidMesh(TriangleMesh mesh, const std::filesystem::path& file,
                                               const MeshPlacement& placement) {
    requireSolid(mesh, file);
    standOnFloor(mesh, file, placement);
    return std::make_shared<const SolidMesh>(std::move(mesh));
}

std::shared_ptr<const SolidMesh> loadSolidMesh(const std::filesystem::path& file,
                                               const MeshPlacement& placement) {
    return makeSolidMesh(importTriangles(file), file, placement);
}

const SolidMeshInfo& meshInfo(const SolidMesh& mesh) {
    return mesh.info();
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
