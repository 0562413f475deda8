// SPDX-License-Identifier: Apache-2.0
// Spheres: every particle in the particle view, and projectiles in every view. Each is one square facing the
// camera in which the sphere is found exactly.
#pragma once
#include <filesystem>
#include <span>

#include "engine/gl/program.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/fracture_mesh.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

class SpherePass {
  public:
    explicit SpherePass(const std::filesystem::path& shaders);

    /// Projectiles of the coming frame.
    void setSpheres(std::span<const SphereDraw> spheres);
    /// The same as a buffer: 32 bytes each, position and radius first.
    const gl::Buffer& spheres() const { return spheres_; }
    size_t sphereCount() const { return sphere_count_; }
    void drawSpheres();
    /// `region` of the shadow map, as ShadowPass::enter().
    void drawSphereShadows(int region);
    void drawSphereIds();
    /// Particles of the body, from the mesh's particle stream.
    void drawParticles(const FractureMesh& mesh, ColourMap colours);
    void drawParticleShadows(const FractureMesh& mesh, int region);
    void drawParticleIds(const FractureMesh& mesh);

  private:
    void drawInstances(const gl::Program& program, const gl::Buffer& instances, size_t count);
    gl::Program shaded_, shadows_, ids_;
    gl::VertexArray no_attributes_;
    gl::Buffer spheres_;
    size_t sphere_count_ = 0;
};

}  // namespace demolish::engine
