// SPDX-License-Identifier: Apache-2.0
// Owner of one OpenGL name: made empty, moved, never copied, deleted once.
#pragma once
#include <glad/gl.h>

#include <utility>

namespace demolish::engine::gl {

/// `Traits::destroy(GLuint)` frees the name. Destruction needs the context that made the object to be
/// current.
template <class Traits>
class Object {
  public:
    Object() = default;
    explicit Object(GLuint id) : id_(id) {}
    Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;
    ~Object() {
        if (id_ != 0) Traits::destroy(id_);
    }

    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

  private:
    GLuint id_ = 0;
};

}  // namespace demolish::engine::gl
