// SPDX-License-Identifier: Apache-2.0
// Corners are made from a grain's number in the vertex stage: 32 bytes a grain are all that travels.
#include "engine/passes/grit_pass.h"

#include "engine/passes/body_geometry.h"
#include "engine/passes/surface_pass.h"

namespace demolish::engine {
namespace {

constexpr GLint kMaterial = 0, kRegion = 0;

}  // namespace

GritPass::GritPass(const std::filesystem::path& shaders)
    : shaded_(shaders, {"grit.vert", "grit.frag"}), shadows_(shaders, {"grit_shadow.vert", "shadow.frag"}) {}

void GritPass::run(const gl::Program& program, const FractureMesh& mesh) {
    bindStorage(StorageBinding::kParticles, mesh.stream(StreamId::kGrains));
    program.use();
    no_attributes_.bind();
    mesh.drawEffect(kGrainCommand, GL_TRIANGLES);
}

void GritPass::draw(const FractureMesh& mesh, const SurfaceLook& look) {
    setBodyMaterial(shaded_, kMaterial, look);
    run(shaded_, mesh);
}

void GritPass::drawShadows(const FractureMesh& mesh, int region) {
    shadows_.set(kRegion, region);
    run(shadows_, mesh);
}

}  // namespace demolish::engine
