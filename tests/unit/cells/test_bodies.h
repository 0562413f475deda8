// SPDX-License-Identifier: Apache-2.0
// The bodies that the cell tests are run on, by name.
#pragma once
#include <memory>
#include <string>

#include "sim_cuda/authoring/mesh_queries.h"

namespace demolish::test {

struct QueriedMesh {
    explicit QueriedMesh(TriangleMesh m) : mesh(std::move(m)), queries(mesh) {}
    TriangleMesh mesh;
    MeshQueries queries;
};

/// Built once. Null where the model file is not there ("bunny", "asteroid-high", "asteroid-low" of glmark2,
/// "rabbit" of the assets); throws std::out_of_range for a name that is not known.
const QueriedMesh* testBody(const std::string& name);

}  // namespace demolish::test
