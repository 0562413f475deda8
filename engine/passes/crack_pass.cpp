// SPDX-License-Identifier: Apache-2.0
// One ribbon of two triangles an edge: an instance each, where the device decides which edges and how many;
// without instances, which software renderers draw one by one, where the CPU has chosen them.
#include "engine/passes/crack_pass.h"

#include <array>

#include "engine/passes/body_geometry.h"
#include "engine/render/shown.h"

namespace demolish::engine {
namespace {

constexpr std::array<uint32_t, 6> kCorners{0, 1, 2, 2, 1, 3};
constexpr GLint kWidth = 0, kNoiseShape = 5,
                kWallColour = 6;  // crack.frag, common/crack.glsl, crack_cover.glsl
constexpr float kRough = 0.49f;   // roughness 1 of a dielectric, as shaders/common/gbuffer.glsl packs it

}  // namespace

CrackPass::CrackPass(const std::filesystem::path& shaders)
    : program_(shaders, {"crack.vert", "crack.frag"}),
      corners_(gl::Buffer::immutable(sizeof(kCorners), kCorners.data())) {}

void setCrackLook(gl::Program& program, const SurfaceLook& look) {
    program.set(kWidth, look.crack_width);
    program.set(kNoiseShape, glm::vec2(look.noise_scale, look.noise_strength));
}

void CrackPass::drawLines(const FractureMesh& mesh, const SeenCracks* seen) {
    bindStorage(StorageBinding::kCrackList,
                seen != nullptr ? seen->lines() : mesh.stream(StreamId::kCrackEdges));
    layout_.setIndices(seen != nullptr ? seen->indices() : corners_);
    layout_.bind();
    if (seen == nullptr) return mesh.drawCommanded(kCrackCommand);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(seen->indexCount()), GL_UNSIGNED_INT, nullptr);
}

void CrackPass::draw(const FractureMesh& mesh, const std::vector<SurfaceLook>& looks,
                     const SeenCracks* seen) {
    bindStorage(StorageBinding::kParticleFragment, mesh.stream(StreamId::kParticleFragment));
    bindStorage(StorageBinding::kTransforms, mesh.stream(StreamId::kTransforms));
    bindStorage(StorageBinding::kCrackEdges, mesh.crackEdges());
    bindStorage(StorageBinding::kExteriorVertices, mesh.exteriorVertices());
    bindStorage(StorageBinding::kCellLooks, mesh.cellLooks());
    glEnable(GL_BLEND);
    // The line blends the material below towards what is inside of it, and rough; the normals stay.
    glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_CONSTANT_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBlendColor(0, 0, 0, kRough);
    glDepthMask(GL_FALSE);
    glDisable(GL_CULL_FACE);
    for (size_t k = 0; k < looks.size(); ++k) {
        if (looks[k].isTransparent()) continue;
        const auto& inside = looks[k].interior_colour;
        setCrackLook(program_, looks[k]);
        program_.set(kWallColour, glm::sqrt(glm::vec3(inside[0], inside[1], inside[2])));
        program_.set(kHiddenLooks, hiddenBut(k, looks));
        program_.use();
        drawLines(mesh, seen);
    }
    glEnable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace demolish::engine
