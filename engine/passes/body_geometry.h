// How a FractureMesh is fed to the vertex stage; shared by the shadow, surface and id passes.
#pragma once
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"

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
    // Of the compute passes that choose triangles; OpenGL promises eight bindings.
    kSourceIndices = 2,
    kSeenBits = 3,
    kBlockCounts = 4,
    kVertices = 5,
    kSourceCommands = 6,
    kCulled = 7,
};

void bindStorage(StorageBinding binding, const gl::Buffer& buffer);

/// Triangles to draw: indices, and the indirect command that says how many.
struct TriangleList {
    const gl::Buffer* indices;
    const gl::Buffer* commands;
    uint32_t command;  ///< its place among the commands
};

/// The body's triangles as one view wants them.
struct BodyTriangles {
    const FractureMesh* mesh;
    TriangleList exterior;  ///< the model's own surface
    TriangleList interior;  ///< exposed broken faces
};
/// All that the mesh's streams hold.
BodyTriangles allTriangles(const FractureMesh& mesh);

class BodyGeometry {
  public:
    BodyGeometry();
    void drawExterior(const BodyTriangles& body);
    void drawInterior(const BodyTriangles& body);

  private:
    void draw(const FractureMesh& mesh, const gl::Buffer& vertices, const TriangleList& triangles);
    gl::VertexArray layout_;
};

}  // namespace demolish::engine
