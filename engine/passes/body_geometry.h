// SPDX-License-Identifier: Apache-2.0
// How a FractureMesh is fed to the vertex stage; shared by the shadow, surface and id passes.
#pragma once
#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/near_faces.h"
#include "engine/render/seen_triangles.h"

namespace demolish::engine {

/// Shader storage bindings of shaders/common/body.glsl and the passes.
enum class StorageBinding : GLuint {
    kParticleFragment = 0,
    kTransforms = 1,
    kParticles = 2,
    kCrackList = 3,
    kCrackEdges = 4,
    kExteriorVertices = 5,
    kTouchedTiles = 6,
    kCellLooks = 7,
    // Of the passes that compute instead of drawing.
    kExteriorIndices = 2,
    kInteriorIndices = 3,
    kComputedExteriorVertices = 4,
    kInteriorVertices = 5,
    kCommands = 6,
    kVisible = 7,
    kFound = 8,
    kTasks = 9,
    kBalls = 10,
    kComputedCellLooks = 10,  // of a pass that knows no balls
    kLarge = 11,
    kGrains = 12,
    kEffectCommands = 13,
    kPuffs = 14,
    kSeenPuffs = 19,
    kPuffBoxes = 20,
    kPuffLists = 21,
    kCount = 22,
    kLooks = 15,  // of bodies that have them, beside the others: LookBuffers
    kNearCells = 16,
    kNearIndices = 17,
    kNearVertices = 18,
    // Of the pass that draws sparks, the last.
    kSparkIds = 8,
    kSparkCommands = 9,
    // Of the passes that make near faces.
    kCellSpheres = 4,
    kReliefSums = 8,
};

/// Of these in one compute shader.
inline constexpr GLint kMostStorageBlocks = 16;

/// The driver has all of the places above.
bool hasAllBindings();
void bindStorage(StorageBinding binding, const gl::Buffer& buffer);
void bindNear(const NearFaces& near);

/// Location in all programs that draw bodies: a bit for each look of which the cells are left out.
inline constexpr GLint kHiddenLooks = 30;
/// In those that draw broken faces: whether to leave out what near faces replace.
inline constexpr GLint kLeavesNear = 29;

class BodyGeometry {
  public:
    BodyGeometry();
    /// The model's own surface; `seen`: no more of it than this, null: all.
    void drawExterior(const FractureMesh& mesh, const SeenList* seen = nullptr);
    /// Exposed broken faces.
    void drawInterior(const FractureMesh& mesh, const SeenList* seen = nullptr);
    /// The same, with `near` in place of those that it replaces; null: nothing. `program` is in use.
    void drawInterior(gl::Program& program, const FractureMesh& mesh, const NearFaces* near,
                      const SeenList* seen);

  private:
    /// `command`: its place among the mesh's commands, of which `indices` are the elements.
    void drawCommanded(const FractureMesh& mesh, const gl::Buffer& vertices, const gl::Buffer& indices,
                       uint32_t command);
    void drawListed(const FractureMesh& mesh, const gl::Buffer& vertices, const TriangleList& list);
    void bind(const FractureMesh& mesh, const gl::Buffer& vertices, const gl::Buffer& indices);
    gl::VertexArray layout_;
};

}  // namespace demolish::engine
