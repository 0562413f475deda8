// SPDX-License-Identifier: Apache-2.0
// A closed mesh on which bodies fall: its triangles as they are drawn, and the signed distances that
// simulations go by.
#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "sim_cuda/api/mesh_repair.h"
#include "sim_cuda/api/model_part.h"
#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {

/// Nodes along each side of a grid, 2..1023.
struct NodeCounts {
    uint32_t x = 2, y = 2, z = 2;
    bool operator==(const NodeCounts&) const = default;
};
/// Of one grid: 256 MiB.
inline constexpr size_t kMostNodes = size_t{1} << 26;

/// Signed distances to a closed surface on the nodes of a regular grid, in steps; negative inside. x runs
/// fastest.
struct DistanceNodes {
    Double3 origin;     ///< m, of the first node
    double step = 1;    ///< m
    double margin = 0;  ///< m, from each side of the grid to the mesh, at least
    NodeCounts count;
    std::vector<float> steps;
};

struct ColliderMesh {
    /// As they are drawn: three corners a triangle, counter-clockwise seen from outside; of each corner its
    /// place (m) and its unit normal, which is the file's or the face's.
    std::vector<float> corners;
    DistanceNodes nodes;
};

struct ColliderMeshOptions {
    UpAxis up = UpAxis::kY;
    RepairOptions repair = {};
    uint32_t cells = 96;  ///< along the longest side, kLeastCells..kMostCells

    bool operator==(const ColliderMeshOptions&) const = default;
};
inline constexpr uint32_t kLeastCells = 8, kMostCells = 800;

/// Repairs the mesh as far as needed and allowed, and measures the distances: where the surface passes they
/// are exact. In the file's own lengths and place, turned where z is up. Throws InputFileError with one
/// sentence that names `file`: what cannot be closed, and more cells than kMostNodes hold; UsageError for
/// cells out of range.
std::shared_ptr<const ColliderMesh> makeColliderMesh(TriangleMesh mesh, const std::filesystem::path& file,
                                                     const ColliderMeshOptions& options = {});

}  // namespace demolish
