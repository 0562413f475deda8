// SPDX-License-Identifier: Apache-2.0
// A body made by hand for pictures and facts: a block of n x n x n cells with jittered corners, optionally
// rounded towards a ball, whose cells can be grouped into fragments and moved. Needs no simulation.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/render/fracture_mesh.h"

namespace demolish::engine::test {

struct BlockOptions {
    int cells = 2;           ///< along each axis
    float size = 1.0f;       ///< m; the block stands on y = 0, centred on the y axis
    float jitter = 0.0f;     ///< of a cell's size, for corners inside the block
    float roundness = 0.0f;  ///< 0: cube, 1: ball
    int subdivisions = 1;    ///< of each cell face
    uint32_t seed = 1;
    float crack_width = 0.006f;  ///< m
    bool turned_lines = false;   ///< of cracks: told from their other ends
    float deep = 0;  ///< m from the outside at which broken faces are as deep as they get; 0: nowhere
};

struct Motion {
    glm::quat rotation{1, 0, 0, 0};  ///< w x y z
    glm::vec3 translation{0, 0, 0};
};

/// Room in a block's mesh.
inline constexpr size_t kMostGrains = 4096, kMostPuffs = 64;

class BlockBody {
  public:
    explicit BlockBody(const BlockOptions& options);

    uint32_t cellCount() const { return static_cast<uint32_t>(cell_centres_.size()); }
    glm::vec3 cellCentre(uint32_t cell) const { return cell_centres_[cell]; }
    size_t crackEdgeCount() const { return crack_edges_.size(); }

    /// Buffers for the GPU; the context must be current.
    /// `cell_looks`: as FractureMeshData.
    FractureMesh makeMesh(std::span<const uint32_t> cell_looks = {}) const;
    /// Groups cells: `slot_of(cell)` is the lowest cell of its fragment. `motion_of(slot)` moves it.
    /// `cracked(a, b)` lists the crack lines between two cells. Writes all streams of the
    /// mesh.
    void write(FractureMesh& mesh, const std::function<uint32_t(uint32_t)>& slot_of,
               const std::function<Motion(uint32_t)>& motion_of,
               const std::function<bool(uint32_t, uint32_t)>& cracked) const;

  private:
    struct Vertex {
        glm::vec3 position;
        uint32_t normal, uv, cell;
    };
    struct CrackLine {
        uint32_t edge, widths;
    };
    struct CrackEdge {
        uint32_t vertex_0, vertex_1, cell_a, cell_b, bond;
    };
    /// Face of a cell as a grid of (subdivisions + 1)^2 points, counter-clockwise seen from outside the cell.
    struct Face {
        uint32_t cell, other;  ///< other: kNone for the outside
        int axis, side;
        std::vector<glm::vec3> points, normals;
    };

    uint32_t cellAt(glm::ivec3 c) const;
    glm::vec3 node(glm::ivec3 n) const;
    Face makeFace(glm::ivec3 cell, int axis, int side) const;
    void smoothOutside(std::vector<Face>& outside) const;
    void appendFace(const Face& face, std::vector<Vertex>& vertices, std::vector<uint32_t>& indices) const;
    void appendCrackEdges(const Face& face, uint32_t first_vertex);

    BlockOptions options_;
    std::vector<glm::vec3> cell_centres_;
    std::vector<Vertex> exterior_;
    std::vector<uint32_t> exterior_indices_;
    std::vector<Face> interior_;  ///< each face twice, once for each of its cells
    std::vector<CrackEdge> crack_edges_;
};

}  // namespace demolish::engine::test
