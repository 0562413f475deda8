// Completeness is checked once, where the attachments are known.
#include "engine/gl/framebuffer.h"

#include <string>
#include <vector>

#include "engine/gl/error.h"

namespace demolish::engine::gl {

Framebuffer::Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth) {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    object_ = Object<FramebufferTraits>(id);
    std::vector<GLenum> outputs;
    for (const Texture* colour : colours) {
        outputs.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(outputs.size()));
        glNamedFramebufferTexture(id, outputs.back(), colour->id(), 0);
    }
    glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(outputs.size()), outputs.data());
    if (outputs.empty()) glNamedFramebufferReadBuffer(id, GL_NONE);
    if (depth != nullptr) glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth->id(), 0);
    const GLenum status = glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw GlError("The driver refuses a framebuffer (status " + std::to_string(status) +
                      "); ask for fewer samples or a smaller picture.");
    }
}

}  // namespace demolish::engine::gl
