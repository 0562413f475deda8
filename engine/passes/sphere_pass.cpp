// SPDX-License-Identifier: Apache-2.0
// Squares instead of meshes: four vertices a particle whatever its size on screen, and a round outline close
// up.
#include "engine/passes/sphere_pass.h"

#include <algorithm>
#include <vector>

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLint kColourMap = 0, kRegion = 0;
constexpr int kMetal = 4;  // beyond the values of ColourMap

/// As the particle stream: 32 bytes.
struct Instance {
    float position[3];
    float radius;
    float value;
    uint32_t fragment;
    uint32_t reserved[2];
};
static_assert(sizeof(Instance) == 32);

}  // namespace

SpherePass::SpherePass(const std::filesystem::path& shaders)
    : shaded_(shaders, {"sphere.vert", "sphere.frag"}),
      shadows_(shaders, {"sphere_shadow.vert", "sphere_shadow.frag"}),
      ids_(shaders, {"sphere.vert", "sphere_id.frag"}),
      spheres_(gl::Buffer::resizable(sizeof(Instance), GL_DYNAMIC_DRAW)) {}

void SpherePass::setSpheres(std::span<const SphereDraw> spheres) {
    std::vector<Instance> instances;
    for (const SphereDraw& sphere : spheres) {
        instances.push_back({{sphere.position[0], sphere.position[1], sphere.position[2]},
                             sphere.radius,
                             0.0f,
                             kSphereId,
                             {}});
    }
    sphere_count_ = instances.size();
    if (instances.empty()) return;
    spheres_.resize(instances.size() * sizeof(Instance));
    spheres_.upload(std::as_bytes(std::span(instances)));
}

void SpherePass::drawInstances(const gl::Program& program, const gl::Buffer& instances, size_t count) {
    if (count == 0) return;
    bindStorage(StorageBinding::kParticles, instances);
    program.use();
    no_attributes_.bind();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

void SpherePass::drawSpheres() {
    shaded_.set(kColourMap, kMetal);
    drawInstances(shaded_, spheres_, sphere_count_);
}

void SpherePass::drawSphereShadows(int region) {
    shadows_.set(kRegion, region);
    drawInstances(shadows_, spheres_, sphere_count_);
}
void SpherePass::drawSphereIds() {
    drawInstances(ids_, spheres_, sphere_count_);
}

void SpherePass::drawParticles(const FractureMesh& mesh, ColourMap colours) {
    shaded_.set(kColourMap, static_cast<int>(colours));
    drawInstances(shaded_, mesh.stream(StreamId::kParticles), mesh.particleCount());
}

void SpherePass::drawParticleShadows(const FractureMesh& mesh, int region) {
    shadows_.set(kRegion, region);
    drawInstances(shadows_, mesh.stream(StreamId::kParticles), mesh.particleCount());
}

void SpherePass::drawParticleIds(const FractureMesh& mesh) {
    drawInstances(ids_, mesh.stream(StreamId::kParticles), mesh.particleCount());
}

}  // namespace demolish::engine
