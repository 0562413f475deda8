// SPDX-License-Identifier: Apache-2.0
// Storage is immutable: a resized target is a new texture, which drivers like better and which cannot be half
// made.
#include "engine/gl/texture.h"

namespace demolish::engine::gl {

namespace {

GLuint newTexture(GLenum target) {
    GLuint id = 0;
    glCreateTextures(target, 1, &id);
    return id;
}

}  // namespace

Texture Texture::make2d(GLenum format, int width, int height, int levels) {
    Texture texture(newTexture(GL_TEXTURE_2D), width, height);
    glTextureStorage2D(texture.id(), levels, format, width, height);
    texture.setFilter(GL_NEAREST, GL_NEAREST);
    texture.setWrap(GL_CLAMP_TO_EDGE);
    return texture;
}

Texture Texture::makeTarget(GLenum format, int width, int height, int samples) {
    if (samples <= 1) return make2d(format, width, height);
    Texture texture(newTexture(GL_TEXTURE_2D_MULTISAMPLE), width, height);
    glTextureStorage2DMultisample(texture.id(), samples, format, width, height, GL_TRUE);
    return texture;
}

Texture Texture::viewTarget(const Texture& target, GLenum format, int samples) {
    GLuint id = 0;
    glGenTextures(1, &id);  // a view gets its target from glTextureView
    Texture view(id, target.width(), target.height());
    glTextureView(id, samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, target.id(), format, 0, 1, 0,
                  1);
    if (samples <= 1) view.setFilter(GL_NEAREST, GL_NEAREST);  // not inherited, and integers know no other
    return view;
}

Texture Texture::make3d(GLenum format, int width, int height, int depth, int levels) {
    Texture texture(newTexture(GL_TEXTURE_3D), width, height);
    glTextureStorage3D(texture.id(), levels, format, width, height, depth);
    texture.setFilter(levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
    texture.setWrap(GL_REPEAT);
    return texture;
}

Texture Texture::makeArray(GLenum format, int width, int height, int layers, int levels) {
    Texture texture(newTexture(GL_TEXTURE_2D_ARRAY), width, height);
    glTextureStorage3D(texture.id(), levels, format, width, height, layers);
    texture.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    texture.setWrap(GL_REPEAT);
    return texture;
}

void Texture::uploadLayer(int layer, const uint8_t* texels) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage3D(id(), 0, 0, 0, layer, width(), height(), 1, GL_RGBA, GL_UNSIGNED_BYTE, texels);
}

void Texture::uploadPart(int x, int y, int width, int height, GLenum format, GLenum type, const void* first,
                         int row) {
    glPixelStorei(GL_UNPACK_ROW_LENGTH, row);
    glTextureSubImage2D(id(), 0, x, y, width, height, format, type, first);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void Texture::makeMipMaps(float anisotropy) {
    glGenerateTextureMipmap(id());
    if (GLAD_GL_ARB_texture_filter_anisotropic != 0)
        glTextureParameterf(id(), GL_TEXTURE_MAX_ANISOTROPY, anisotropy);
}

void Texture::clear(GLenum components, GLenum type) {
    glClearTexImage(id(), 0, components, type, nullptr);
}

void Texture::setFilter(GLenum minify, GLenum magnify) {
    glTextureParameteri(id(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minify));
    glTextureParameteri(id(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnify));
}

void Texture::setWrap(GLenum wrap) {
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(id(), axis, static_cast<GLint>(wrap));
    }
}

Sampler::Sampler() {
    GLuint id = 0;
    glCreateSamplers(1, &id);
    object_ = Object<SamplerTraits>(id);
}

}  // namespace demolish::engine::gl
