// SPDX-License-Identifier: Apache-2.0
// A software renderer shades blocks of pixels, which records fill.
#include "engine/passes/named_pass.h"

#include "engine/passes/surface_pass.h"

namespace demolish::engine {
namespace {

constexpr GLint kWhich = 1, kMaterial = 8;
constexpr GLuint kFirstUnit = 3;  // of both programs
constexpr int kAcross = static_cast<int>(SurfaceRecords::kAcross), kTexels = 4;

void drawWhole(int left, int low, int across, int up) {
    glScissor(left, low, across, up);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

NamedPass::Programs& NamedPass::programsFor(SolidTexture texture) {
    Programs& programs = programs_[texture];
    if (programs[0].id() != 0) return programs;
    for (const auto part : {SurfaceRecords::kOutside, SurfaceRecords::kInside})
        programs[part] = gl::Program(
            shaders_, {"whole_picture.vert", "surface_record.frag"},
            textureDefine(texture) + (part == SurfaceRecords::kInside ? "#define INTERIOR\n" : ""));
    return programs;
}

void NamedPass::makeMaterials(const SurfaceLook& look, const SurfaceRecords& records) {
    const int rows = static_cast<int>(records.all().size()) / kAcross;
    if (records_.height() < rows) {
        records_ = gl::Texture::make2d(GL_RGBA32UI, kTexels * kAcross, 2 * rows);
        materials_ = gl::Texture::make2d(GL_RGBA8, kAcross, 2 * rows);
        normals_ = gl::Texture::make2d(GL_RGBA16, kAcross, 2 * rows);
        made_ = gl::Framebuffer({&materials_, &normals_}, nullptr);
    }
    records_.uploadPart(0, 0, kTexels * kAcross, rows, GL_RGBA_INTEGER, GL_UNSIGNED_INT, records.all().data(),
                        0);
    records_.bind(kFirstUnit);
    made_.bind();
    glViewport(0, 0, kAcross, materials_.height());
    Programs& programs = programsFor(look.texture);
    for (const auto part : {SurfaceRecords::kOutside, SurfaceRecords::kInside}) {
        const auto& [first, count] = records.rowsOf(part);
        setBodyMaterial(programs[part], kMaterial, look);
        programs[part].use();
        if (count > 0) drawWhole(0, static_cast<int>(first), kAcross, static_cast<int>(count));
    }
}

void NamedPass::uploadSamples(const SmallTriangles& small, const RenderTargets& targets) {
    // With several samples, Mesa's software renderer also draws a column beside what glScissor leaves: there
    // must be nothing.
    PixelBox box = small.touched(0);
    box = {box.left - 1, box.low - 1, box.right + 1, box.high + 1};
    box.cutTo(targets.width, targets.height);
    const int row = targets.width * targets.samples, first = targets.samples * box.left;
    if (samples_.width() != row || samples_.height() != targets.height)
        samples_ = gl::Texture::make2d(GL_RG32UI, row, targets.height);
    samples_.uploadPart(first, box.low, targets.samples * box.width(), box.height(), GL_RG_INTEGER,
                        GL_UNSIGNED_INT, small.named().data() + box.low * row + first, row);
}

void NamedPass::draw(const SurfaceLook& look, const SmallTriangles& small, const RenderTargets& targets) {
    const PixelBox& box = small.touched(0);
    if (box.isEmpty() || small.records().all().empty()) return;
    uploadSamples(small, targets);
    no_attributes_.bind();
    glEnable(GL_SCISSOR_TEST);
    makeMaterials(look, small.records());
    targets.scene.bind();
    glViewport(0, 0, targets.width, targets.height);
    samples_.bind(kFirstUnit);
    materials_.bind(kFirstUnit + 1);
    normals_.bind(kFirstUnit + 2);
    if (samples_program_.id() == 0)
        samples_program_ = gl::Program(shaders_, {"whole_picture.vert", "named_sample.frag"});
    samples_program_.use();
    for (int sample = 0; sample < targets.samples; ++sample) {
        samples_program_.set(kWhich, glm::ivec2(sample, targets.samples));
        drawWhole(box.left, box.low, box.width(), box.height());
    }
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace demolish::engine
