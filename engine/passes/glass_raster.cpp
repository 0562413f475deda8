// SPDX-License-Identifier: Apache-2.0
// Where few multiprocessors draw, four layers of two million triangles took 7 ms.
#include "engine/passes/glass_raster.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/gl/framebuffer.h"

namespace demolish::engine {
namespace {

constexpr GLuint kOpaqueUnit = 7;  // shaders/common/put_face.glsl
constexpr GLint kScattered = 12;   // shaders/common/put_sums.glsl
constexpr size_t kSumBytes = 16;
constexpr GLint kBindings = static_cast<GLint>(StorageBinding::kCount);
constexpr std::array kMiddle = {glm::vec2(0.5f)};

void hide(TriangleRaster::Programs& programs, uint32_t looks) {
    for (gl::Program* program : {&programs.triangles, &programs.large}) program->set(kHiddenLooks, looks);
}

}  // namespace

GlassRaster::GlassRaster(const std::filesystem::path& shaders, size_t task_room)
    : shaders_(shaders), triangles_(shaders, task_room) {}

/// Depth and name.
size_t GlassRaster::words(const RenderTargets& targets, int across) {
    const auto rays = static_cast<size_t>(across) * static_cast<size_t>(across);
    return 2 * kKept * rays * static_cast<size_t>(targets.width) * static_cast<size_t>(targets.height);
}

bool GlassRaster::suits(const FractureMesh& mesh, const RenderTargets& targets, int across) {
    GLint bindings = 0, blocks = 0;
    GLint64 bytes = 0;
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    const size_t largest =
        std::max(sizeof(uint32_t) * words(targets, across), TriangleRaster::foundBytes(mesh, 0));
    return bindings >= kBindings && blocks >= kMostStorageBlocks && static_cast<size_t>(bytes) >= largest;
}

std::string GlassRaster::defines(int across) {
    return "#define FACES\n#define KEPT " + std::to_string(kKept) + "\n#define ACROSS " +
           std::to_string(across) + "\n";
}

void GlassRaster::prepare(const RenderTargets& targets, int across) {
    TriangleRaster::Programs& programs = programs_[{targets.samples, across}];
    if (casting_.large.id() == 0) {
        casting_ = triangles_.make("#define FACES\n#define SUMS\n", kMiddle);
        show_sums_ = gl::Program(shaders_, {"glass_sums.comp"});
    }
    if (programs.large.id() != 0) return;
    programs = triangles_.make(
        defines(across) + "#define PICTURE_SAMPLES " + std::to_string(targets.samples) + "\n", kMiddle);
}

void GlassRaster::bind(const FractureMesh& mesh) const {
    triangles_.bind(mesh);
    bindStorage(StorageBinding::kVisible, faces_);
    bindStorage(StorageBinding::kComputedCellLooks, mesh.cellLooks());
}

void GlassRaster::find(const FractureMesh& mesh, const RenderTargets& targets, int across,
                       uint32_t hidden_looks) {
    prepare(targets, across);
    TriangleRaster::Programs& programs = programs_[{targets.samples, across}];
    const size_t fours = (words(targets, across) + 3) / 4, bytes = 16 * fours;
    const bool anew = faces_.size() != bytes;
    if (anew) {
        faces_ = {};  // both at once might not fit into a small GPU
        faces_ = gl::Buffer::immutable(bytes);
    }
    triangles_.makeRoom(mesh, 0);
    bind(mesh);
    triangles_.clear(anew ? fours : 0, 0);
    targets.depth.bind(kOpaqueUnit);
    hide(programs, hidden_looks);
    for (const bool naming : {false, true}) {
        if (naming && !TriangleRaster::namesLater()) break;
        TriangleRaster::runSmall(programs, naming);
        TriangleRaster::runLarge(programs, naming);
    }
}

void GlassRaster::castSums(const FractureMesh& mesh, uint32_t hidden_looks, float scattered,
                           const gl::Texture& sums, const gl::Texture& ends) {
    const bool anew = !sums_;
    if (anew) sums_ = gl::Buffer::immutable(kSumBytes * kSumTexels * kSumTexels);
    triangles_.makeRoom(mesh, 0);
    triangles_.bind(mesh);
    bindStorage(StorageBinding::kVisible, sums_);
    bindStorage(StorageBinding::kComputedCellLooks, mesh.cellLooks());
    triangles_.clear(anew ? sums_.size() / 16 : 0, 0);
    hide(casting_, hidden_looks);
    for (gl::Program* program : {&casting_.triangles, &casting_.squares, &casting_.large})
        program->set(kScattered, scattered);
    TriangleRaster::runSmall(casting_, false);
    TriangleRaster::runLarge(casting_, false);
    glBindImageTexture(0, sums.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    glBindImageTexture(1, ends.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    for (GLuint level = 1; level < kSumLevels; ++level)
        glBindImageTexture(1 + level, sums.id(), static_cast<GLint>(level), GL_FALSE, 0, GL_WRITE_ONLY,
                           GL_RG32F);
    show_sums_.use();
    glDispatchCompute(gl::tilesAlong(kSumTexels), gl::tilesAlong(kSumTexels), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace demolish::engine
