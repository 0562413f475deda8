// SPDX-License-Identifier: Apache-2.0
// Whole steps are added, so that a frame has the same light every time.
#include "engine/passes/caustics_pass.h"

#include "engine/gl/framebuffer.h"
#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLuint kEndsUnit = 3, kSumsUnit = 14;
constexpr size_t kStepBytes = 16;
constexpr int kCoarseTexels = 64;  // shaders/common/caustics.glsl
constexpr GLuint kPlaces = CausticsPass::kTexels * CausticsPass::kTexels + kCoarseTexels * kCoarseTexels;
constexpr GLuint kLevels = 2;

}  // namespace

CausticsPass::CausticsPass(const std::filesystem::path& shaders)
    : empty_(shaders, {"caustics_empty.comp"}),
      cast_(shaders, {"caustics_cast.comp"}),
      show_(shaders, {"caustics_show.comp"}),
      steps_(gl::Buffer::immutable(kStepBytes * kPlaces)),
      light_(gl::Texture::make2d(GL_RGBA16F, kTexels, kTexels, static_cast<int>(kLevels))) {
    light_.setFilter(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
    light_.setWrap(GL_CLAMP_TO_EDGE);
}

void CausticsPass::cast(const gl::Texture& sums, const gl::Texture& ends) {
    ends.bind(kEndsUnit);
    sums.bind(kSumsUnit);
    bindStorage(StorageBinding::kVisible, steps_);
    empty_.use();
    glDispatchCompute(kPlaces / 64, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    cast_.use();
    glDispatchCompute(gl::tilesAlong(kTexels), gl::tilesAlong(kTexels), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    for (GLuint level = 0; level < kLevels; ++level)
        glBindImageTexture(level, light_.id(), static_cast<GLint>(level), GL_FALSE, 0, GL_WRITE_ONLY,
                           GL_RGBA16F);
    show_.use();
    glDispatchCompute(gl::tilesAlong(kTexels), gl::tilesAlong(kTexels), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace demolish::engine
