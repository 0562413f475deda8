// SPDX-License-Identifier: Apache-2.0
// The pictures that a frame is drawn into before it reaches the caller's framebuffer; remade when the size
// changes.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>

#include "engine/gl/framebuffer.h"
#include "engine/gl/texture.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

struct RenderTargets {
    /// Sizes in px, samples 1, 2 or 4. Throws gl::GlError.
    RenderTargets(int width_px, int height_px, int sample_count);
    bool fits(int width_px, int height_px, int sample_count) const {
        return width == width_px && height == height_px && samples == sample_count;
    }

    int width, height, samples;
    gl::Texture material;                    ///< RGBA8, as shaders/common/gbuffer.glsl packs it
    gl::Texture normals;                     ///< RGBA16, likewise
    gl::Texture material_bits, normal_bits;  ///< the same memory as unsigned integers, R32UI and RG32UI
    gl::Texture depth;                       ///< 32 bit float, reversed
    gl::Texture display;                     ///< RGBA8, sRGB encoded, single sample
    gl::Framebuffer scene, depth_only, resolved;
    /// What is in `display`, into a framebuffer of the same size.
    void show(GLuint framebuffer) const;
    std::array<glm::vec2, 4> sample_position;  ///< inside the pixel, 0..1, as the driver puts them
};

/// Makes them anew where they do not fit the view; with as many samples as it asks for and the driver offers.
/// True if it did.
bool fitTargets(std::optional<RenderTargets>& targets, const FrameView& view);

}  // namespace demolish::engine
