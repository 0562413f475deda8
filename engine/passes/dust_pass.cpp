// SPDX-License-Identifier: Apache-2.0
// Optical depths add up, so that puffs need no order: their light is a mean, weighted by depth.
#include "engine/passes/dust_pass.h"

#include <string>

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLint kDust = 0, kPixels = 1, kSquares = 2;
constexpr GLuint kSolidUnit = 4, kSumUnit = 12;
/// Of the picture's sides; half size is not told from full. As shaders/common/dust_over.glsl.
constexpr int kFullPart = 2, kDraftPart = 4;
/// px: sides of the sums' tiles, as shaders/dust_sum.comp, and of the squares that puffs are listed for: at
/// least, and twice as long until they are so few.
constexpr int kTile = 8, kLeastSquare = 64, kMostSquares = 256;
constexpr size_t kGroup = 64;  ///< puffs, as shaders/dust_see.comp
/// B, as shaders/common/seen_puff.glsl and puff_boxes.glsl.
constexpr size_t kSeenPuffBytes = 80, kBoxBytes = 8;
/// m: wavelength of the lumps, in first wavelengths of the shading noise (a fifth of the spacing).
constexpr float kLumpWaves = 22;

struct Squares {
    int side, columns, rows;
    int count() const { return columns * rows; }
};
Squares squaresOf(int width, int height) {
    for (int side = kLeastSquare;; side *= 2) {
        const Squares squares{side, (width + side - 1) / side, (height + side - 1) / side};
        if (squares.count() <= kMostSquares) return squares;
    }
}

}  // namespace

DustPass::DustPass(const std::filesystem::path& shaders)
    : shaders_(shaders), nothing_(gl::Texture::make2d(GL_RG16F, 1, 1)) {
    nothing_.clear(GL_RG, GL_FLOAT);
}

void DustPass::prepare(const PictureKind& kind, const RenderTargets& targets, bool computes) {
    kind_ = kind;
    kind_.samples = targets.samples;
    computes_ = computes && hasAllBindings();
    if (!computes_) return;
    Tiles& tiles = tiles_[kind_];
    if (tiles.sum.id() == 0) {
        const std::string text = defines(kind_) + "#define FULL\n";
        tiles = {gl::Program(shaders_, {"dust_see.comp"}, text),
                 gl::Program(shaders_, {"dust_list.comp"}, text),
                 gl::Program(shaders_, {"dust_sum.comp"}, text)};
    }
}

gl::Program& DustPass::puffsFor(bool full) {
    gl::Program& program = puffs_[{full, kind_}];
    if (program.id() == 0)
        program = gl::Program(shaders_, {"dust.vert", "dust.frag"},
                              defines(kind_) + (full ? "#define FULL\n" : ""));
    return program;
}

void DustPass::fit(int width, int height) {
    if (sums_ && sums_->texture.width() == width && sums_->texture.height() == height) return;
    gl::Texture texture = gl::Texture::make2d(GL_RGBA16F, width, height);
    texture.setFilter(GL_LINEAR, GL_LINEAR);
    sums_.emplace();
    sums_->texture = std::move(texture);
    sums_->framebuffer = gl::Framebuffer({&sums_->texture}, nullptr);
}

void DustPass::tell(gl::Program& program, const FrameView& view, int part) {
    const auto& colour = view.look.dust_colour;
    program.set(kDust, glm::vec4(colour[0], colour[1], colour[2], 1 / (kLumpWaves * view.look.noise_scale)));
    program.set(kPixels, static_cast<float>(part));
}

void DustPass::makeRoom(size_t puffs, size_t squares) {
    if (seen_.size() != puffs * kSeenPuffBytes) {
        seen_ = gl::Buffer::immutable(puffs * kSeenPuffBytes);
        boxes_ = gl::Buffer::immutable(puffs * kBoxBytes);
    }
    const size_t lists = squares * (puffs + 1) * sizeof(GLuint);
    if (lists_.size() != lists) lists_ = gl::Buffer::immutable(lists);
}

/// Into sums that are 0 before.
void DustPass::drawPuffs(const gl::Program& program, const FractureMesh& mesh) {
    const float nothing[4] = {0, 0, 0, 0};
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    program.use();  // first: some drivers hold the last pass's program against the shadow map as they clear
    glClearNamedFramebufferfv(sums_->framebuffer.id(), GL_COLOR, 0, nothing);
    sums_->framebuffer.bind();
    glViewport(0, 0, sums_->texture.width(), sums_->texture.height());
    bindStorage(StorageBinding::kPuffs, mesh.stream(StreamId::kPuffs));
    no_attributes_.bind();
    mesh.drawEffect(kPuffCommand, GL_TRIANGLE_STRIP);
    glDisable(GL_BLEND);
}

void DustPass::compute(const FractureMesh& mesh, const FrameView& view, Tiles& tiles) {
    const gl::Buffer& puffs = mesh.stream(StreamId::kPuffs);
    const gl::Texture& sums = sums_->texture;
    const Squares squares = squaresOf(sums.width(), sums.height());
    makeRoom(puffs.size() / kPuffBytes, static_cast<size_t>(squares.count()));
    bindStorage(StorageBinding::kPuffs, puffs);
    bindStorage(StorageBinding::kEffectCommands, mesh.stream(StreamId::kEffectCommands));
    bindStorage(StorageBinding::kSeenPuffs, seen_);
    bindStorage(StorageBinding::kPuffBoxes, boxes_);
    bindStorage(StorageBinding::kPuffLists, lists_);
    glBindImageTexture(0, sums.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);
    tell(tiles.sum, view, kFullPart);
    tiles.see.set(kPixels, static_cast<float>(kFullPart));
    const auto run = [&](gl::Program& program, int columns, int rows, GLbitfield barrier) {
        program.set(kSquares, glm::ivec4(sums.width(), sums.height(), squares.side, squares.columns));
        program.use();
        glDispatchCompute(static_cast<GLuint>(columns), static_cast<GLuint>(rows), 1);
        glMemoryBarrier(barrier);
    };
    run(tiles.see, static_cast<int>((puffs.size() / kPuffBytes + kGroup - 1) / kGroup), 1,
        GL_SHADER_STORAGE_BARRIER_BIT);
    run(tiles.list, squares.count(), 1, GL_SHADER_STORAGE_BARRIER_BIT);
    run(tiles.sum, (sums.width() + kTile - 1) / kTile, (sums.height() + kTile - 1) / kTile,
        GL_TEXTURE_FETCH_BARRIER_BIT);
}

void DustPass::addUp(const FractureMesh* mesh, const FrameView& view, const RenderTargets& targets,
                     const gl::Texture* nearest_depth) {
    if (mesh == nullptr) return nothing_.bind(kSumUnit);
    const bool full = nearest_depth != nullptr;
    const int part = full ? kFullPart : kDraftPart;
    fit((targets.width + part - 1) / part, (targets.height + part - 1) / part);
    (full ? *nearest_depth : targets.depth).bind(kSolidUnit);
    if (full && computes_) {
        compute(*mesh, view, tiles_.at(kind_));
    } else {
        gl::Program& program = puffsFor(full);
        tell(program, view, part);
        drawPuffs(program, *mesh);
    }
    sums_->texture.bind(kSumUnit);
}

}  // namespace demolish::engine
