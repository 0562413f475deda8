// SPDX-License-Identifier: Apache-2.0
// Owning framebuffer; the textures belong to whoever attached them and must outlive it.
#pragma once
#include <initializer_list>

#include "engine/gl/object.h"
#include "engine/gl/texture.h"

namespace demolish::engine::gl {

struct FramebufferTraits {
    static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};

class Framebuffer {
  public:
    Framebuffer() = default;
    /// Colour targets in order of their shader outputs, perhaps none; `depth` may be null. Throws GlError
    /// when the driver finds the set incomplete.
    Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth);

    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, id()); }
    GLuint id() const { return object_.id(); }

  private:
    Object<FramebufferTraits> object_;
};

/// The texture behind a framebuffer's colour when a compute shader can write it in place of drawing:
/// single-sample, of exactly this size and format, level 0. 0 when it is anything else (the window, say).
GLuint writableTexture(GLuint framebuffer, int width, int height, GLenum format);

/// What reads or copies a picture that was computed waits for these.
inline constexpr GLbitfield kPictureBarriers = GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                                               GL_PIXEL_BUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT;
/// Groups of 8 along so many pixels.
GLuint tilesAlong(int pixels);
/// Runs the program in use, with groups of 8 x 8 pixels, on a texture as its image 0.
void computePicture(GLuint picture, GLenum format, int width, int height);

}  // namespace demolish::engine::gl
