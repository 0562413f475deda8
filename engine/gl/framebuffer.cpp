// Completeness is checked once, where the attachments are known.
#include "engine/gl/framebuffer.h"

#include <string>

#include "engine/gl/error.h"

namespace demolish::engine::gl {

Framebuffer::Framebuffer(const Texture* colour, const Texture* depth) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    object_ = Object<FramebufferTraits>(id);
    if (colour != nullptr) {
        glNamedFramebufferTexture(id, GL_COLOR_ATTACHMENT0, colour->id(), 0);
    } else {
        glNamedFramebufferDrawBuffer(id, GL_NONE);
        glNamedFramebufferReadBuffer(id, GL_NONE);
    }
    if (depth != nullptr) glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth->id(), 0);
    const GLenum status = glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw GlError("The driver refuses a framebuffer (status " + std::to_string(status) +
                      "); ask for fewer samples or a smaller picture.");
    }
}

}  // namespace demolish::engine::gl
