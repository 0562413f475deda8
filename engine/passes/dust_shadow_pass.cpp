// SPDX-License-Identifier: Apache-2.0
#include "engine/passes/dust_shadow_pass.h"

#include <glad/gl.h>

#include <algorithm>

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLuint kDustShadowUnit = 11, kSumImage = 0, kShadowImage = 1;
constexpr int kTexels = 256;          ///< along; as shaders/common/dust_cast.glsl
constexpr int kTile = 8;              ///< as shaders/dust_shadow.comp
constexpr size_t kMostGroups = 4096;  ///< each takes a puff, and another one so many farther on

}  // namespace

DustShadowPass::DustShadowPass(const std::filesystem::path& shaders)
    : cast_(shaders, {"dust_cast.comp"}),
      show_(shaders, {"dust_shadow.comp"}),
      nothing_(gl::Texture::make2d(GL_RG16F, 1, 1)) {
    nothing_.clear(GL_RG, GL_FLOAT);
}

void DustShadowPass::cast(const FractureMesh* mesh) {
    if (mesh == nullptr) return nothing_.bind(kDustShadowUnit);
    if (shadow_.id() == 0) {
        sums_ = gl::Texture::make2d(GL_R32UI, kTexels, 2 * kTexels);
        sums_.clear(GL_RED_INTEGER, GL_UNSIGNED_INT);
        shadow_ = gl::Texture::make2d(GL_RG16F, kTexels, kTexels);
        shadow_.setFilter(GL_LINEAR, GL_LINEAR);
    }
    const gl::Buffer& puffs = mesh->stream(StreamId::kPuffs);
    bindStorage(StorageBinding::kPuffs, puffs);
    bindStorage(StorageBinding::kEffectCommands, mesh->stream(StreamId::kEffectCommands));
    glBindImageTexture(kSumImage, sums_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    glBindImageTexture(kShadowImage, shadow_.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG16F);
    cast_.use();
    glDispatchCompute(static_cast<GLuint>(std::min(puffs.size() / kPuffBytes, kMostGroups)), 1, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    show_.use();
    glDispatchCompute(kTexels / kTile, kTexels / kTile, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    shadow_.bind(kDustShadowUnit);
}

}  // namespace demolish::engine
