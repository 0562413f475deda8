// SPDX-License-Identifier: Apache-2.0
// Meshes and cells of a shot's bodies: each mesh read once, each filling made once, whoever shares it.
#pragma once
#include <memory>
#include <vector>

#include "app/session/shot.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/model_file.h"

namespace demolish {

struct BodyFillings {
    struct ReadMesh {
        std::filesystem::path model;
        MeshPlacement placement;
        std::shared_ptr<const SolidMesh> mesh;
        ModelContents contents = {};  ///< of the file
        Double3 size_in_file = {};    ///< lengths of the file
    };
    struct Filling {
        std::shared_ptr<const SolidMesh> mesh;
        FillOptions options;
        std::shared_ptr<const BreakableBody> body;
    };
    std::vector<ReadMesh> meshes;
    std::vector<Filling> fillings;
    std::vector<std::shared_ptr<const BreakableBody>> of_body;  ///< one a body of the shot
    std::shared_ptr<const SolidMesh> subject_mesh;              ///< of subjectOf()
    std::shared_ptr<const BreakableBody> subject;
};

/// Along x, y, z; 0 for no vertices.
Double3 sizeOf(const TriangleMesh& mesh);

/// `reuse`: meshes and fillings that are taken over where they are what is wanted; may be null. Throws
/// UsageError when the particles are too few or too many, the errors of authoring, and Cancelled.
BodyFillings makeBodyFillings(const Shot& shot, bool on_gpu, bool draw_geometry, const BodyFillings* reuse,
                              const ProgressCallback& progress);

}  // namespace demolish
