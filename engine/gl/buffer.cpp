// SPDX-License-Identifier: Apache-2.0
// Direct state access only, so that no binding of the caller is disturbed.
#include "engine/gl/buffer.h"

#include <cassert>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/gl/error.h"

namespace demolish::engine::gl {
namespace {

GLuint createBuffer() {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    return id;
}

}  // namespace

Buffer Buffer::immutable(size_t size, const void* data, GLbitfield flags) {
    assert(size > 0);
    Buffer buffer;
    buffer.object_ = Object<BufferTraits>(createBuffer());
    buffer.size_ = size;
    glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(size), data, flags);
    return buffer;
}

Buffer Buffer::resizable(size_t size, GLenum usage) {
    Buffer buffer;
    buffer.object_ = Object<BufferTraits>(createBuffer());
    buffer.usage_ = usage;
    buffer.resize(size);
    return buffer;
}

Buffer Buffer::zeros(size_t size, GLenum usage) {
    Buffer buffer = resizable(size, usage);
    buffer.upload(std::vector<std::byte>(size));
    return buffer;
}

void Buffer::resize(size_t size) {
    assert(usage_ != 0);
    size_ = size;
    glNamedBufferData(id(), static_cast<GLsizeiptr>(size), nullptr, usage_);
}

void Buffer::upload(std::span<const std::byte> data, size_t offset) {
    assert(offset + data.size() <= size_);
    if (data.empty()) return;
    glNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()),
                         data.data());
}

void Buffer::download(std::span<std::byte> data, size_t offset) const {
    assert(offset + data.size() <= size_);
    if (data.empty()) return;
    glGetNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()),
                            data.data());
}

BufferReading::BufferReading(const Buffer& buffer)
    : id_(buffer.id()),
      size_(buffer.size()),
      data_(glMapNamedBufferRange(id_, 0, static_cast<GLsizeiptr>(size_), GL_MAP_READ_BIT)) {
    if (data_ == nullptr)
        throw GlError("The driver does not show a buffer of " + std::to_string(size_) + " bytes");
}

BufferReading::~BufferReading() {
    glUnmapNamedBuffer(id_);
}

}  // namespace demolish::engine::gl
