// SPDX-License-Identifier: Apache-2.0
// A model file's triangles, and the solid they enclose: the two halves of loadSolidMesh(), for those who read
// the file in another process than they use it in (app/reading).
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/model_looks.h"
#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

/// What else the file holds.
struct ModelContents {
    uint32_t meshes = 0, materials = 0;
    uint32_t textures = 0;      ///< different pictures that its materials name, embedded or not
    bool is_in_metres = false;  ///< the format says its unit, and lengths were turned into metres
    /// In the file's lengths: no finer are places told, as far from its origin as they lie. Numbers of files
    /// are read in single precision.
    float coarseness = 0;

    bool operator==(const ModelContents&) const = default;
};

/// By the ending of its name: lengths of the format have a unit, or files of it name theirs.
bool saysItsUnit(const std::filesystem::path& file);

struct ImportedModel {
    TriangleMesh mesh;
    ModelContents contents = {};
    std::shared_ptr<const ModelLooks> looks = {};  ///< null: the file says nothing of them
};

/// Reads every triangle of the file's scene (node transforms applied, in metres where the format says its
/// unit), welds vertices of equal position and drops triangles that lost a corner by it. Not checked yet
/// whether it is closed. Pictures are decoded, embedded or beside the file; those that are missing, damaged
/// or too large are left out, with a note. `node`: as ModelPart's. Throws InputFileError: no plain file,
/// unreadable, no such node (with the names of those that are there), no triangles,
/// faces of vertices that are not there, numbers that are not finite. A damaged file may still end the
/// process, by a fault in the library that reads it.
ImportedModel importModel(const std::filesystem::path& file, const std::string& node = {});
/// The same of several nodes; they share their looks.
std::vector<ImportedModel> importModels(const std::filesystem::path& file,
                                        const std::vector<std::string>& nodes);
/// The mesh alone.
TriangleMesh importTriangles(const std::filesystem::path& file);

/// Turns z upwards where that is up (placement.part), repairs the mesh as far as needed and allowed
/// (placement.repair), checks it and stands it on the floor
/// (lowest y = 0, centred in x and z). Throws InputFileError with one sentence that names `file`: no
/// triangles, still not closed (with the count of open edges), triangles that are there twice, zero or
/// negative volume, too large or too small to be scaled; UsageError for a height that is not positive.
/// `looks`: what the corners' materials are numbers in.
std::shared_ptr<const SolidMesh> makeSolidMesh(TriangleMesh mesh, const std::filesystem::path& file,
                                               const MeshPlacement& placement = {},
                                               std::shared_ptr<const ModelLooks> looks = {});

}  // namespace demolish
