// SPDX-License-Identifier: Apache-2.0
// Two programs from one text: the branch between materials is made once a draw, not once a pixel.
#include "engine/passes/surface_pass.h"

#include "engine/render/shown.h"

namespace demolish::engine {
namespace {

constexpr GLint kMaterial = 0;  // shaders/common/body_material.glsl

/// How much of a solid has the second colour, as its shader makes it: of grains, which are too small for a
/// pattern.
float shareOf(SolidTexture texture) {
    switch (texture) {
        case SolidTexture::kNone:
            return 0;
        case SolidTexture::kVeins:
        case SolidTexture::kBricks:
        case SolidTexture::kGrains:
            return 0.12f;
        case SolidTexture::kCrystals:
            return 0.25f;
        case SolidTexture::kLayers:
        case SolidTexture::kPebbles:
            return 0.45f;
    }
    return 0;
}

}  // namespace

SurfacePass::SurfacePass(const std::filesystem::path& shaders) : shaders_(shaders), named_(shaders) {}

SurfacePass::Programs& SurfacePass::programsFor(SolidTexture texture, bool with_looks) {
    Programs& programs = programs_[{texture, with_looks}];
    if (programs.exterior.id() == 0) {
        const std::string solid = textureDefine(texture);
        programs.exterior = gl::Program(shaders_, {"surface.vert", "surface.frag"},
                                        solid + (with_looks ? "#define LOOKS\n" : ""));
        programs.interior =
            gl::Program(shaders_, {"surface.vert", "surface.frag"}, solid + "#define INTERIOR\n");
    }
    return programs;
}

void SurfacePass::draw(BodyGeometry& body, const FractureMesh& mesh, const FrameView& view, bool with_looks,
                       const NearFaces* near, const SeenMesh* seen, const RenderTargets& targets) {
    const SeenList* list = seen != nullptr ? &seen->onPicture() : nullptr;
    const std::vector<SurfaceLook> looks = looksOf(view);
    const bool both_sides = with_looks && mesh.looks()->isDoubleSided();
    for (size_t k = 0; k < looks.size(); ++k) {
        if (looks[k].isTransparent()) continue;
        Programs& programs = programsFor(looks[k].texture, with_looks);
        const SurfaceLook shown = with_looks ? withoutCoat(looks[k]) : looks[k];
        for (gl::Program* program : {&programs.exterior, &programs.interior}) {
            setBodyMaterial(*program, kMaterial, shown);
            program->set(kHiddenLooks, hiddenBut(k, looks));
        }
        programs.exterior.use();
        if (both_sides) glDisable(GL_CULL_FACE);
        body.drawExterior(mesh, list);
        if (both_sides) glEnable(GL_CULL_FACE);
        programs.interior.use();
        body.drawInterior(programs.interior, mesh, near, list);
    }
    if (seen != nullptr && seen->small() != nullptr) named_.draw(looks[0], *seen->small(), targets);
}

SurfaceLook withoutCoat(SurfaceLook look) {
    look.coat = 0;
    return look;
}

std::string textureDefine(SolidTexture texture) {
    return "#define TEXTURE " + std::to_string(static_cast<int>(texture)) + "\n";
}

void setBodyMaterial(gl::Program& program, GLint location, const SurfaceLook& look) {
    const auto &outside = look.exterior_colour, &inside = look.interior_colour;
    program.set(location, glm::vec4(outside[0], outside[1], outside[2], look.exterior_roughness));
    program.set(location + 1, glm::vec4(inside[0], inside[1], inside[2], look.interior_roughness));
    program.set(location + 2,
                glm::vec3(look.noise_scale, look.noise_strength, look.relief_height > 0 ? 1.0f : 0.0f));
    const auto& other = look.texture_colour;
    program.set(location + 3, glm::vec4(other[0], other[1], other[2], shareOf(look.texture)));
    program.set(location + 4,
                glm::vec4(1 / look.texture_size, look.texture_outside, look.coat, look.variation));
}

}  // namespace demolish::engine
