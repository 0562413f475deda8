// SPDX-License-Identifier: Apache-2.0
// Owning textures (immutable storage) and samplers.
#pragma once
#include <cstdint>

#include "engine/gl/object.h"

namespace demolish::engine::gl {

struct TextureTraits {
    static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct SamplerTraits {
    static void destroy(GLuint id) { glDeleteSamplers(1, &id); }
};

class Texture {
  public:
    Texture() = default;
    static Texture make2d(GLenum format, int width, int height, int levels = 1);
    /// `samples` > 1: a multisample texture, else a plain one.
    static Texture makeTarget(GLenum format, int width, int height, int samples);
    /// The texels of a makeTarget() texture, read as another format of the same size. Shares the memory.
    static Texture viewTarget(const Texture& target, GLenum format, int samples);
    static Texture make3d(GLenum format, int width, int height, int depth, int levels = 1);

    /// RGBA of 8 bits; repeats, filtered between mip maps once these are made.
    static Texture makeArray(GLenum format, int width, int height, int layers, int levels);
    /// Of the array's size, RGBA, row after row.
    void uploadLayer(int layer, const uint8_t* texels);
    /// Into a plain 2D texture, at `x`, `y`. `first`: of a picture of `row` texels a row, in client memory.
    void uploadPart(int x, int y, int width, int height, GLenum format, GLenum type, const void* first,
                    int row);
    /// `anisotropy`: most texels of a footprint along its longer side, where the driver can.
    void makeMipMaps(float anisotropy);

    /// All texels of the first level are 0; in the format's own components, such as GL_RED_INTEGER.
    void clear(GLenum components, GLenum type);
    void setFilter(GLenum minify, GLenum magnify);
    void setWrap(GLenum wrap);
    void bind(GLuint unit) const { glBindTextureUnit(unit, id()); }

    GLuint id() const { return object_.id(); }
    int width() const { return width_; }
    int height() const { return height_; }
    explicit operator bool() const { return static_cast<bool>(object_); }

  private:
    Texture(GLuint id, int width, int height) : object_(id), width_(width), height_(height) {}
    Object<TextureTraits> object_;
    int width_ = 0, height_ = 0;
};

class Sampler {
  public:
    Sampler();
    void set(GLenum parameter, GLint value) { glSamplerParameteri(object_.id(), parameter, value); }
    void bind(GLuint unit) const { glBindSampler(unit, object_.id()); }

  private:
    Object<SamplerTraits> object_;
};

}  // namespace demolish::engine::gl
