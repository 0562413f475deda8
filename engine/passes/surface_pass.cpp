// Two programs from one text: the branch between materials is made once a draw, not once a pixel.
#include "engine/passes/surface_pass.h"

namespace demolish::engine {
namespace {

constexpr GLint kMaterial = 0, kNoiseShape = 1;

}  // namespace

SurfacePass::SurfacePass(const std::filesystem::path& shaders)
    : exterior_(shaders, {"surface.vert", "surface.frag"}),
      interior_(shaders, {"surface.vert", "surface.frag"}, "#define INTERIOR\n") {}

void SurfacePass::draw(BodyGeometry& body, const BodyTriangles& triangles, const SurfaceLook& look) {
    const glm::vec2 noise_shape(look.noise_scale, look.noise_strength);
    const auto& outside = look.exterior_colour;
    exterior_.set(kMaterial, glm::vec4(outside[0], outside[1], outside[2], look.exterior_roughness));
    exterior_.set(kNoiseShape, noise_shape);
    exterior_.use();
    body.drawExterior(triangles);
    const auto& inside = look.interior_colour;
    interior_.set(kMaterial, glm::vec4(inside[0], inside[1], inside[2], look.interior_roughness));
    interior_.set(kNoiseShape, noise_shape);
    interior_.use();
    body.drawInterior(triangles);
}

}  // namespace demolish::engine
