// SPDX-License-Identifier: Apache-2.0
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

GLuint writableTexture(GLuint framebuffer, int width, int height, GLenum format) {
    if (framebuffer == 0) return 0;
    const auto attached = [framebuffer](GLenum what) {
        GLint value = 0;
        glGetNamedFramebufferAttachmentParameteriv(framebuffer, GL_COLOR_ATTACHMENT0, what, &value);
        return value;
    };
    if (attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE) return 0;
    if (attached(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL) != 0) return 0;
    const auto texture = static_cast<GLuint>(attached(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
    const auto property = [texture](GLenum what) {
        GLint value = 0;
        glGetTextureLevelParameteriv(texture, 0, what, &value);
        return value;
    };
    const bool fits = property(GL_TEXTURE_INTERNAL_FORMAT) == static_cast<GLint>(format) &&
                      property(GL_TEXTURE_SAMPLES) == 0 && property(GL_TEXTURE_WIDTH) == width &&
                      property(GL_TEXTURE_HEIGHT) == height && property(GL_TEXTURE_DEPTH) == 1;
    return fits ? texture : 0;
}

GLuint tilesAlong(int pixels) {
    return static_cast<GLuint>(pixels + 7) / 8;
}

void computePicture(GLuint picture, GLenum format, int width, int height) {
    glBindImageTexture(0, picture, 0, GL_FALSE, 0, GL_WRITE_ONLY, format);
    glDispatchCompute(tilesAlong(width), tilesAlong(height), 1);
    glMemoryBarrier(kPictureBarriers);
}

}  // namespace demolish::engine::gl
