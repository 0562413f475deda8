// SPDX-License-Identifier: Apache-2.0
// A mesh as it came from a file in, a closed one out.
#pragma once
#include "sim_cuda/api/mesh_repair.h"
#include "sim_cuda/authoring/repair/repair_mesh.h"

namespace demolish {

struct RepairedMesh {
    TriangleMesh mesh;
    /// By triangle the number of the file's that it is of, or, after a remesh, that it lies nearest to;
    /// kNoSource for caps and rims. Empty: each is its own.
    std::vector<uint32_t> source;
    RepairReport report;
};

/// Each step only as far as needed; a closed mesh of one part passes untouched, except with
/// RepairMode::kRemesh. `options.thickness` is in the mesh's own unit. What comes out may still be open,
/// where the mode forbids what would close it, or have no triangles; requireSolid() says so.
RepairedMesh repairMesh(TriangleMesh mesh, const RepairOptions& options);

/// A closed mesh with a new surface, whatever it was: for bodies whose cells come out open or without volume.
RepairedMesh withNewSurface(const RepairedMesh& closed, RemeshCause cause);

}  // namespace demolish
