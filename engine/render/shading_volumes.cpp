// SPDX-License-Identifier: Apache-2.0
#include "engine/render/shading_volumes.h"

#include <algorithm>

#include "engine/render/cell_volume.h"
#include "engine/render/noise_volume.h"
#include "engine/render/shown.h"

namespace demolish::engine {
namespace {

constexpr GLuint kNoiseUnit = 2, kCellUnit = 13;

bool hasCells(const SurfaceLook& look) {
    return look.texture >= SolidTexture::kCrystals;
}

}  // namespace

ShadingVolumes::ShadingVolumes() : noise_(makeNoiseVolume()) {
    draft_noise_.set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    draft_noise_.set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void ShadingVolumes::bind(const FrameView& view) {
    noise_.bind(kNoiseUnit);
    if (view.quality == RenderQuality::kDraft) draft_noise_.bind(kNoiseUnit);
    const auto looks = looksOf(view);
    if (std::none_of(looks.begin(), looks.end(), hasCells)) return;
    if (!cells_) cells_ = makeCellVolume();
    cells_.bind(kCellUnit);
}

void ShadingVolumes::unbind() {
    glBindSampler(kNoiseUnit, 0);
}

}  // namespace demolish::engine
