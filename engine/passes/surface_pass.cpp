// SPDX-License-Identifier: Apache-2.0
// Two programs from one text: the branch between materials is made once a draw, not once a pixel.
#include "engine/passes/surface_pass.h"

namespace demolish::engine {
namespace {

constexpr GLint kMaterial = 0;  // shaders/common/body_material.glsl

}  // namespace

SurfacePass::SurfacePass(const std::filesystem::path& shaders)
    : exterior_(shaders, {"surface.vert", "surface.frag"}),
      interior_(shaders, {"surface.vert", "surface.frag"}, "#define INTERIOR\n") {}

void SurfacePass::draw(BodyGeometry& body, const FractureMesh& mesh, const SurfaceLook& look) {
    for (gl::Program* program : {&exterior_, &interior_}) setBodyMaterial(*program, kMaterial, look);
    exterior_.use();
    body.drawExterior(mesh);
    interior_.use();
    body.drawInterior(mesh);
}

void setBodyMaterial(gl::Program& program, GLint location, const SurfaceLook& look) {
    const auto &outside = look.exterior_colour, &inside = look.interior_colour;
    program.set(location, glm::vec4(outside[0], outside[1], outside[2], look.exterior_roughness));
    program.set(location + 1, glm::vec4(inside[0], inside[1], inside[2], look.interior_roughness));
    program.set(location + 2, glm::vec2(look.noise_scale, look.noise_strength));
}

}  // namespace demolish::engine
