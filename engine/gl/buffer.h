// SPDX-License-Identifier: Apache-2.0
// Owning OpenGL buffer: immutable or resizable storage.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/gl/object.h"

namespace demolish::engine::gl {

struct BufferTraits {
    static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};

class Buffer {
  public:
    Buffer() = default;

    /// Immutable storage of `size` bytes (> 0); `flags` as glNamedBufferStorage; `data` may be null.
    static Buffer immutable(size_t size, const void* data = nullptr, GLbitfield flags = 0);
    /// Resizable storage, the kind that foreign APIs register. `usage` as glNamedBufferData. Contents
    /// undefined.
    static Buffer resizable(size_t size, GLenum usage = GL_DYNAMIC_COPY);

    /// The same, of zeros. They are uploaded: NVIDIA's driver has cleared large buffers
    /// (glClearNamedBufferData) after what was uploaded into them next, and so lost it.
    static Buffer zeros(size_t size, GLenum usage = GL_DYNAMIC_COPY);

    /// Throws away the contents; only for resizable buffers.
    void resize(size_t size);
    /// Copies into the buffer from `offset` bytes on; resizable, or immutable with GL_DYNAMIC_STORAGE_BIT.
    void upload(std::span<const std::byte> data, size_t offset = 0);
    /// Reads back; waits for the GPU. For tests and rare queries.
    void download(std::span<std::byte> data, size_t offset = 0) const;

    GLuint id() const { return object_.id(); }
    size_t size() const { return size_; }  ///< bytes
    explicit operator bool() const { return static_cast<bool>(object_); }

  private:
    Object<BufferTraits> object_;
    size_t size_ = 0;
    GLenum usage_ = 0;  ///< 0: immutable
};

/// A buffer's bytes where they lie, for as long as this lives; the buffer must stay as it is meanwhile. Cheap
/// in software alone: elsewhere they come back from the GPU.
class BufferReading {
  public:
    explicit BufferReading(const Buffer& buffer);
    ~BufferReading();
    BufferReading(const BufferReading&) = delete;
    BufferReading& operator=(const BufferReading&) = delete;

    template <class T>
    std::span<const T> as() const {
        return {static_cast<const T*>(data_), size_ / sizeof(T)};
    }

  private:
    GLuint id_;
    size_t size_;
    const void* data_;
};

}  // namespace demolish::engine::gl
