// Owning framebuffer; the textures belong to whoever attached them and must outlive it.
#pragma once
#include "engine/gl/object.h"
#include "engine/gl/texture.h"

namespace demolish::engine::gl {

struct FramebufferTraits {
    static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};

class Framebuffer {
  public:
    Framebuffer() = default;
    /// Either attachment may be null. Throws GlError when the driver finds the pair incomplete.
    Framebuffer(const Texture* colour, const Texture* depth);

    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, id()); }
    GLuint id() const { return object_.id(); }

  private:
    Object<FramebufferTraits> object_;
};

}  // namespace demolish::engine::gl
